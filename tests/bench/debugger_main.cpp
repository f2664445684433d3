// The debugger's waiting times in one game, and the cost of traces.
//
//   bench_debugger SEED HALF PLACES GAMES    half [s]; places to go to; games with and without traces
//
// Prints one line of JSON.
#include <algorithm>
#include <chrono>
#include <cstdio>
#include <cstdlib>
#include <vector>

#include "robot/core/json_library.h"
#include "sim/agent/trace.h"
#include "sim/debug/session.h"
#include "sim/debug/setup.h"
#include "sim/match/step.h"

namespace {

using namespace sim;

State begun(const Params& params, std::uint64_t seed) {
  referee::Events events;
  return begin(params, {.seed = seed}, events);
}

/// Returns the time that `work` takes [ms].
template <class Work>
double milliseconds_of(Work&& work) {
  const auto begin = std::chrono::steady_clock::now();
  work();
  return std::chrono::duration<double, std::milli>(std::chrono::steady_clock::now() - begin).count();
}

/// Plays a game. With traces, those of all robots are made.
void play(const Params& params, std::uint64_t seed, bool traces) {
  static agent::Trace all[kMaxRobots];
  referee::Events events;
  for (State state = begun(params, seed); !finished(state);)
    traces ? step(params, state, events, kEverybody, all) : step(params, state, events);
}

}  // namespace

int main(int count, char** words) {
  if (count != 5) return 2;
  const std::uint64_t seed = std::strtoull(words[1], nullptr, 10);
  const int places = std::atoi(words[3]), games = std::atoi(words[4]);
  const auto prepared = debug::prepare({});
  if (!prepared) return 2;
  auto longer = std::make_shared<debug::Setup>(**prepared);
  longer->params.rules.half_duration = std::strtof(words[2], nullptr);
  const debug::SharedSetup setup = longer;
  const Params& params = setup->params;

  // the first run keeps the key frames
  debug::Timeline timeline(setup, begun(params, seed));
  const State last = timeline.at(kNever);
  std::vector<double> to_tick, cold;
  for (int i = 0; i < places; ++i) {
    const auto tick = static_cast<Tick>(static_cast<std::uint64_t>(i) * 7919 * 31 % last.world.tick);
    to_tick.push_back(milliseconds_of([&] { timeline.at(tick); }));
    cold.push_back(milliseconds_of([&] { debug::Timeline(setup, begun(params, seed)).at(tick); }));
  }

  // conditions that hold nowhere: the whole game is searched
  nlohmann::json searches = nlohmann::json::object();
  for (const char* condition : {"14/3 ball_distance < 0 m", "14/3 ball_error > 20 m",
                                "skill is stand and 14/2 pose_error > 20 m", "ball_x > 14 m"}) {
    debug::Session session(setup, begun(params, seed), {.home = 14, .away = 5});
    searches[condition] = milliseconds_of([&] { (void)session.run(std::string("until ") + condition); });
  }

  // in turns, so that other programs disturb both alike
  double with = 0, without = 0;
  for (int game = 0; game < games; ++game) {
    const std::uint64_t number = seed + static_cast<std::uint64_t>(game);
    without += milliseconds_of([&] { play(params, number, false); });
    with += milliseconds_of([&] { play(params, number, true); });
  }
  const nlohmann::json report = {{"ticks", last.world.tick},
                                 {"key_frames_bytes", timeline.bytes()},
                                 {"key_frames_every", timeline.interval()},
                                 {"goto_ms", to_tick},
                                 {"cold_goto_ms", cold},
                                 {"search_ms", searches},
                                 {"game_ms", without / games},
                                 {"traced_game_ms", with / games}};
  std::printf("%s\n", report.dump().c_str());
  return 0;
}
