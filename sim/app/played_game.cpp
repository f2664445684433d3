#include "sim/app/played_game.h"

#include <algorithm>
#include <optional>
#include <utility>

#include "sim/app/game_file.h"
#include "sim/match/hash.h"
#include "sim/match/shoot_out.h"
#include "sim/match/step.h"

namespace sim::app {
namespace {

void take_notes(const State& state, const referee::Events& events, report::GameReport& report) {
  const referee::Book& book = state.book;
  const auto count = std::min<std::size_t>(static_cast<std::size_t>(events.count), events.list.size());
  for (std::size_t i = 0; i < count; ++i)
    report.decisions.push_back({.event = events.list[i],
                                .half = book.half,
                                .clock = static_cast<float>(book.clock) * kTickDuration,
                                .score = {book.score[0], book.score[1]}});
}

void count_events(report::GameReport& report) {
  for (const report::Decision& decision : report.decisions) report.result.count(decision.event);
}

/// Returns the last tick of a game of at most `seconds`; 0: no limit.
Tick end_of(const State& state, float seconds) { return seconds > 0 ? state.world.tick + ticks(seconds) : kNever; }

}  // namespace

Tick expected_ticks(const field::Rules& rules) { return ticks(rules.half_duration) * static_cast<Tick>(rules.halves); }

robot::Result<report::GameReport> play_one(const contest::Cast& cast, const contest::Openings& openings,
                                           const GameWish& wish, Recording* recording, ProgressBar* progress,
                                           const std::function<void(const State&)>& watch) {
  const Params& params = cast.params();
  report::GameReport report{.seed = wish.seed};
  referee::Events events;
  State state = openings.begin(params, wish.seed, events);
  take_notes(state, events, report);
  if (watch) watch(state);

  std::optional<robot::bridge::SimulatedGame> game;
  std::optional<GameFile> file;
  if (recording) {
    game.emplace(params, recording->names, state);
    auto made = GameFile::create(recording->path, *game, wish.seed);
    if (!made) return made.failure();
    file.emplace(std::move(*made));
    if (const auto added = file->add(*game); !added) return added.failure();
  }

  const Tick end = end_of(state, wish.seconds);
  const Tick expected = expected_ticks(params.rules);
  while (!finished(state) && state.world.tick < end && !cast.failed()) {
    if (game) {
      game->tick(events);
      state = game->state();
      if (const auto added = file->add(*game); !added) return added.failure();
    } else {
      step(params, state, events);
    }
    take_notes(state, events, report);
    if (watch) watch(state);
    if (progress) progress->at(std::min(state.world.tick, expected));
  }
  if (cast.failed()) return robot::Error{cast.problem()};
  report.hash = hash_of_game(state);
  report.result = result_of(state);
  count_events(report);
  const bool drawn = finished(state) && state.book.score[0] == state.book.score[1];
  if (wish.shoot_out && drawn) report.shoot_out = play_shoot_out(params, {.seed = wish.seed});
  if (cast.failed()) return robot::Error{cast.problem()};
  if (file) {
    if (const auto closed = file->close(); !closed) return closed.failure();
    recording->messages = file->messages(), recording->size_bytes = file->size_bytes();
  }
  return report;
}

}  // namespace sim::app
