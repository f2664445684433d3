// sim_cost [GAMES [together [narrow]]]: the cost of a spl2012 game and of a State, as one line of JSON. With `together`, all
// games are played side by side, and with `narrow` in lanes that each processor of this kind has. Needs only the standard
// library.
#include <algorithm>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <vector>

#include "sim/app/cycles.h"
#include "sim/io/matchup.h"
#include "sim/match/play.h"
#include "sim/math/lanes.h"

namespace {

using namespace sim;

double median_of(std::vector<double> values) {
  std::sort(values.begin(), values.end());
  return values[values.size() / 2];
}

/// Returns the time of a copy of a state in the middle of a game [ns], among many states.
double copy_ns(const Params& params) {
  constexpr std::size_t kStates = 32;  // 256 kB: they fit the second cache, as in rollouts
  constexpr int kCopies = 1'000'000;
  referee::Events events;
  State state = begin(params, {.seed = 1}, events);
  play_on(params, state, 3000);
  std::vector<State> states(kStates, state);
  const std::uint64_t begin = app::computed_ns();
  for (std::size_t i = 0; i < kCopies; ++i) {
    states[(7 * i + 1) % kStates] = states[i % kStates];
    asm volatile("" : : "r"(states.data()) : "memory");
  }
  return static_cast<double>(app::computed_ns() - begin) / kCopies;
}

}  // namespace

int main(int count, char** words) {
  const int games = count > 1 ? std::atoi(words[1]) : 20;
  const auto is = [&](int index, const char* word) { return count > index && std::strcmp(words[index], word) == 0; };
  const bool together = is(2, "together"), narrow = together && is(3, "narrow");
  if (games < 1 || count > (narrow ? 4 : together ? 3 : 2)) {
    std::fprintf(stderr, "sim_cost: expected how many games, at least 1, and perhaps 'together [narrow]', got '%s'\n",
                 count > 1 ? words[count - 1] : "");
    return 2;
  }
  const auto prepared = io::prepare({});
  if (!prepared) {
    std::fprintf(stderr, "sim_cost: %s\n", prepared.error().c_str());
    return 2;
  }

  only_narrow_lanes = narrow;
  play_game(prepared->params, {.seed = 0});  // warms the caches and the clock
  std::vector<double> game_ms, cycles;
  const auto measure = [&](int first, int number) {
    std::vector<RandomKey> keys;
    for (int game = first; game < first + number; ++game) keys.push_back({.seed = static_cast<std::uint64_t>(game)});
    const double clock = app::cycles_per_ns();
    const std::uint64_t begin = app::computed_ns();
    Tick ticks = 0;
    for (const Result& result : play_games(prepared->params, keys)) ticks += result.ticks;
    const auto ns = static_cast<double>(app::computed_ns() - begin);
    game_ms.push_back(ns / 1e6 / number);
    cycles.push_back(ns * clock / (2.0 * prepared->params.rules.players * ticks));
  };
  if (together)
    measure(1, games);
  else
    for (int game = 1; game <= games; ++game) measure(game, 1);
  std::printf("{\"games\":%d,\"game_ms\":%g,\"robot_tick_cycles\":%g,\"state_bytes\":%u,\"copy_ns\":%g}\n", games,
              median_of(game_ms), median_of(cycles), static_cast<unsigned>(sizeof(State)), copy_ns(prepared->params));
  return 0;
}
