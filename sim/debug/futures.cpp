#include "sim/debug/futures.h"

#include <cassert>
#include <optional>
#include <utility>

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

/// One future, tick by tick.
class Future {
 public:
  Future(const Moment& moment, int number) : setup_(*moment.setup), state_(moment.state) {
    state_.world.key = luck_of(state_.world.key, number);
    if (!moment.past) return;
    game_.emplace(*moment.past);
    game_->change(state_, moment.setup);
  }

  const State& state() const { return state_; }
  bool over() const { return finished(state_); }
  void step() {
    if (game_)
      state_ = game_->at(state_.world.tick + 1);
    else
      sim::step(setup_.params, state_, events_);
  }

 private:
  const Setup& setup_;
  State state_;
  referee::Events events_;
  std::optional<Timeline> game_;  // with behaviours from outside
};

/// The end of one future.
struct End {
  int scored = 0, conceded = 0;  // goals of the side and of the other one
  std::uint64_t hash = 0;
};

/// Plays a future. Its path is added to `paths` unless that is nullptr.
End play_on(const Moment& moment, int robot, int number, Tick length, std::vector<FuturePath>* paths) {
  Future future(moment, number);
  const State& state = future.state();
  const Tick begin = state.world.tick;
  const auto goals = [&](Side whose) {
    const int index = static_cast<int>(whose);
    return state.book.score[index] - moment.state.book.score[index];
  };
  const Side side = side_of(robot);
  FuturePath path;
  for (Tick played = 0; played <= length; ++played) {
    if (paths && played % FuturePath::kSpacing == 0 && goals(side) + goals(other(side)) == 0) {
      path.ball.push_back(state.world.ball.position);
      // one that is sent off stays where it was
      const Body& body = state.world.bodies[robot];
      const bool is_gone = !on_field(body) && !path.robot.empty();
      path.robot.push_back(is_gone ? path.robot.back() : body.position);
    }
    if (state.world.tick == begin + length || future.over()) break;
    future.step();
  }
  if (paths) paths->push_back(std::move(path));
  return {goals(side), goals(other(side)), hash_of(state)};
}

Effect effect_of(const std::vector<double>& without, const std::vector<double>& with) {
  std::vector<double> gains;
  for (std::size_t i = 0; i < with.size(); ++i) gains.push_back(with[i] - without[i]);
  const contest::Mean gain = contest::mean_of(gains);
  return {contest::mean_of(without).mean, contest::mean_of(with).mean, gain.mean - kSigmas95 * gain.error,
          gain.mean + kSigmas95 * gain.error};
}

void find_parting(const Pair& pair, Tick length, Futures& result) {
  Future without(pair.without, 0), with(pair.with, 0);
  for (Tick played = 0; played < length && !without.over() && !with.over(); ++played) {
    without.step(), with.step();
    result.field = difference(without.state(), with.state());
    if (result.field.empty()) continue;
    result.parting = without.state().world.tick;
    return;
  }
}

}  // namespace

Futures futures(const std::vector<Pair>& pairs, int robot, Tick length) {
  assert(pairs.size() >= 2);
  Futures result;
  result.count = static_cast<int>(pairs.size());
  result.begin = pairs.front().without.state.world.tick;
  std::vector<double> scores[2], concedes[2], goals[2];  // without, with
  for (int number = 0; number < result.count; ++number) {
    const Pair& pair = pairs[static_cast<std::size_t>(number)];
    const bool keeps_path = number < Futures::kPaths;
    const End ends[2] = {play_on(pair.without, robot, number, length, keeps_path ? &result.paths_without : nullptr),
                         play_on(pair.with, robot, number, length, keeps_path ? &result.paths_with : nullptr)};
    result.different += ends[0].hash != ends[1].hash;
    for (const int which : {0, 1}) {
      scores[which].push_back(ends[which].scored > 0);
      concedes[which].push_back(ends[which].conceded > 0);
      goals[which].push_back(ends[which].scored - ends[which].conceded);
    }
  }
  result.scores = effect_of(scores[0], scores[1]);
  result.concedes = effect_of(concedes[0], concedes[1]);
  result.goals = effect_of(goals[0], goals[1]);
  find_parting(pairs.front(), length, result);
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
