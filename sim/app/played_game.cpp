#include "sim/app/played_game.h"

#include <algorithm>
#include <optional>
#include <utility>

#include "sim/app/game_file.h"
#include "sim/match/hash.h"
#include "sim/match/shoot_out.h"
#include "sim/match/step.h"

namespace sim::app {

Tick end_of(const State& state, float seconds) { return seconds > 0 ? state.world.tick + ticks(seconds) : kNever; }

NotedGame::NotedGame(const contest::Cast& cast, const contest::Openings& openings, const GameWish& wish)
    : cast_(cast), wish_(wish), report_{.seed = wish.seed} {
  referee::Events events;
  state = openings.begin(cast.params(), wish.seed, events);
  end_ = end_of(state, wish.seconds);
  see(events);
}

void NotedGame::see(const referee::Events& events) {
  const referee::Book& book = state.book;
  for (const referee::Event& event : events)
    report_.decisions.push_back({.event = event,
                                 .half = book.half,
                                 .clock = static_cast<float>(book.clock) * kTickDuration,
                                 .score = {book.score[0], book.score[1]}});
}

report::GameReport NotedGame::report() {
  report_.hash = hash_of_game(state);
  report_.result = result_of(state);
  for (const report::Decision& decision : report_.decisions) report_.result.count(decision.event);
  const bool drawn = finished(state) && state.book.score[0] == state.book.score[1];
  if (wish_.shoot_out && drawn) report_.shoot_out = play_shoot_out(cast_.params(), {.seed = wish_.seed});
  return std::move(report_);
}

Tick expected_ticks(const field::Rules& rules) { return ticks(rules.half_duration) * static_cast<Tick>(rules.halves); }

robot::Result<report::GameReport> play_one(const contest::Cast& cast, const contest::Openings& openings,
                                           const GameWish& wish, Recording* recording, ProgressBar* progress,
                                           const std::function<void(const State&)>& watch) {
  const Params& params = cast.params();
  NotedGame noted(cast, openings, wish);
  if (watch) watch(noted.state);

  std::optional<robot::bridge::SimulatedGame> game;
  std::optional<GameFile> file;
  if (recording) {
    game.emplace(params, recording->names, noted.state);
    auto made = GameFile::create(recording->path, *game, wish.seed);
    if (!made) return made.failure();
    file.emplace(std::move(*made));
    if (const auto added = file->add(*game); !added) return added.failure();
  }

  const Tick expected = expected_ticks(params.rules);
  referee::Events events;
  while (!finished(noted.state) && noted.goes_on() && !cast.failed()) {
    if (game) {
      game->tick(events);
      noted.state = game->state();
      if (const auto added = file->add(*game); !added) return added.failure();
    } else {
      step(params, noted.state, events);
    }
    noted.see(events);
    if (watch) watch(noted.state);
    if (progress) progress->at(std::min(noted.state.world.tick, expected));
  }
  if (cast.failed()) return robot::Error{cast.problem()};
  report::GameReport report = noted.report();
  if (cast.failed()) return robot::Error{cast.problem()};
  if (file) {
    if (const auto closed = file->close(); !closed) return closed.failure();
    recording->messages = file->messages(), recording->size_bytes = file->size_bytes();
  }
  return report;
}

}  // namespace sim::app
