#include "robot/app/truth/watched_game.h"

#include <algorithm>
#include <mutex>
#include <utility>

#include "robot/bridge/to_messages.h"
#include "sim/match/step.h"

namespace robot::app {
namespace {

sim::State kick_off_of(const sim::Params& params, std::uint64_t seed) {
  sim::referee::Events events;
  return sim::begin(params, {seed}, events);
}

}  // namespace

Result<std::unique_ptr<WatchedGame>> WatchedGame::open(WatchedGameOptions options) {
  options.matchup.pace = sim::Pace::every_tick;  // otherwise bodies far from the ball move in leaps
  auto game = sim::io::prepare(options.matchup);
  if (!game) return game.failure();
  return std::unique_ptr<WatchedGame>(new WatchedGame(std::move(options), std::move(*game)));
}

WatchedGame::WatchedGame(WatchedGameOptions options, sim::io::PreparedGame game)
    : options_(std::move(options)),
      game_(std::move(game)),
      state_(kick_off_of(game_.params, options_.seed)),
      seed_(options_.seed) {
  show();
}

void WatchedGame::tell_ticks(OnTick on_tick) {
  const std::lock_guard guard(lock_);
  on_tick_ = std::move(on_tick);
  if (on_tick_) on_tick_(seen_.back().world, seen_.back().capture_ns);
}

float WatchedGame::ball_radius() const { return game_.params.teams[0].models.ball.radius; }

sim::World WatchedGame::at(std::uint64_t capture_ns) {
  const std::lock_guard guard(lock_);
  const bridge::Timeline timeline{.epoch_ns = options_.begin_ns};
  while (timeline.at(static_cast<sim::Tick>(ticks_ + 1)) <= capture_ns) play_tick();
  const auto after =
      std::find_if(seen_.begin(), seen_.end(), [&](const Seen& seen) { return seen.capture_ns > capture_ns; });
  return after == seen_.begin() ? seen_.front().world : std::prev(after)->world;
}

void WatchedGame::play_tick() {
  if (sim::finished(state_)) {
    state_ = kick_off_of(game_.params, ++seed_);
  } else {
    sim::referee::Events events;
    sim::step(game_.params, state_, events);
  }
  ++ticks_;
  show();
}

void WatchedGame::show() {
  const std::uint64_t capture_ns = bridge::Timeline{.epoch_ns = options_.begin_ns}.at(static_cast<sim::Tick>(ticks_));
  seen_.push_back({.capture_ns = capture_ns, .world = state_.world});
  if (seen_.size() > kKept) seen_.pop_front();
  if (on_tick_) on_tick_(state_.world, capture_ns);
}

}  // namespace robot::app
