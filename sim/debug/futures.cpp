#include "sim/debug/futures.h"

#include <cassert>
#include <vector>

#include "robot/core/text.h"
#include "sim/contest/series.h"
#include "sim/match/fields.h"
#include "sim/match/hash.h"
#include "sim/match/step.h"

namespace sim::debug {
namespace {

using robot::formatted;

constexpr double kSigmas95 = 1.96;

/// Returns the seed of a future. The first one keeps the luck of the game.
RandomKey luck_of(RandomKey own, int number) {
  if (number == 0) return own;
  Hash hash;
  hash.add(own.seed), hash.add(static_cast<std::uint64_t>(number));
  return {hash.value()};
}

struct Score {
  int scored = 0, conceded = 0;
  std::uint64_t hash = 0;
};

Score play_on(const Moment& moment, Side side, int number, Tick length) {
  State state = moment.state;
  state.world.key = luck_of(state.world.key, number);
  const Tick end = state.world.tick + length;
  referee::Events events;
  while (state.world.tick < end && !finished(state)) step(moment.setup->params, state, events);
  const auto goals = [&](Side whose) {
    const int index = static_cast<int>(whose);
    return state.book.score[index] - moment.state.book.score[index];
  };
  return {goals(side), goals(other(side)), hash_of(state)};
}

Effect effect_of(const std::vector<double>& without, const std::vector<double>& with) {
  std::vector<double> gains;
  for (std::size_t i = 0; i < with.size(); ++i) gains.push_back(with[i] - without[i]);
  const contest::Mean gain = contest::mean_of(gains);
  return {contest::mean_of(without).mean, contest::mean_of(with).mean, gain.mean - kSigmas95 * gain.error,
          gain.mean + kSigmas95 * gain.error};
}

void find_parting(const Moment& without, const Moment& with, Tick length, Futures& result) {
  State a = without.state, b = with.state;
  referee::Events events;
  const Tick end = a.world.tick + length;
  while (a.world.tick < end && !finished(a) && !finished(b)) {
    step(without.setup->params, a, events);
    step(with.setup->params, b, events);
    result.field = difference(a, b);
    if (result.field.empty()) continue;
    result.parting = a.world.tick;
    return;
  }
}

}  // namespace

Futures futures(const Moment& without, const Moment& with, Side side, int count, Tick length) {
  assert(count >= 2 && without.state.world.tick == with.state.world.tick);
  Futures result;
  result.count = count;
  std::vector<double> scores[2], concedes[2], goals[2];  // without, with
  for (int number = 0; number < count; ++number) {
    const Score pair[2] = {play_on(without, side, number, length), play_on(with, side, number, length)};
    result.different += pair[0].hash != pair[1].hash;
    for (const int which : {0, 1}) {
      scores[which].push_back(pair[which].scored > 0);
      concedes[which].push_back(pair[which].conceded > 0);
      goals[which].push_back(pair[which].scored - pair[which].conceded);
    }
  }
  result.scores = effect_of(scores[0], scores[1]);
  result.concedes = effect_of(concedes[0], concedes[1]);
  result.goals = effect_of(goals[0], goals[1]);
  find_parting(without, with, length, result);
  return result;
}

std::string text_of(const Futures& futures, Tick length) {
  const double seconds = static_cast<double>(age(length, 0));
  std::string text =
      formatted("%d pairs of futures of %g s, %d of them differ\n", futures.count, seconds, futures.different);
  const auto share = [&](const char* what, const Effect& effect) {
    text += formatted("%-16s %6.1f %% -> %5.1f %%    95 %% %+.1f .. %+.1f\n", what, 100 * effect.without,
                      100 * effect.with, 100 * effect.low, 100 * effect.high);
  };
  share("scores", futures.scores);
  share("concedes", futures.concedes);
  text += formatted("%-16s %6.2f   -> %5.2f      95 %% %+.2f .. %+.2f\n", "goal difference", futures.goals.without,
                    futures.goals.with, futures.goals.low, futures.goals.high);
  if (!futures.parting) return text + "with the luck of this game nothing differs\n";
  return text + formatted("with the luck of this game they part at %.2f s, first in %s\n",
                          static_cast<double>(age(*futures.parting, 0)), futures.field.c_str());
}

}  // namespace sim::debug
