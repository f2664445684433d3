#include "sim/match/play.h"

#include <algorithm>

namespace sim {
namespace {

/// Fills in everything but the events.
void sum_up(const State& state, Result& result) {
  result.counts = state.counts;
  result.ticks = state.world.tick;
  result.over = finished(state);
  for (int side = 0; side < 2; ++side) {
    result.score[side] = state.book.score[side];
    result.packets[side] = state.book.packets[side];
  }
  for_each_robot(state.world.players, [&](int robot) {
    result.walked[static_cast<int>(side_of(robot))] += state.world.bodies[robot].walked;
  });
}

Result play_on(const Params& params, State& state, Tick most, Result result) {
  const Tick end = most < kNever - state.world.tick ? state.world.tick + most : kNever;
  play(
      params, state, [&](const State& now) { return now.world.tick >= end; },
      [&](const referee::Event& event) { result.count(event); });
  sum_up(state, result);
  return result;
}

}  // namespace

void Result::count(const referee::Event& event) {
  const auto side = static_cast<int>(event.side);
  ++events[static_cast<int>(event.kind)][side];
  if (event.kind != referee::Event::Kind::ball_free) return;
  ++(event.robot != kNobody ? taken : expired)[static_cast<int>(event.set_play)][side];
}

float Result::possession(Side side) const {
  const std::uint32_t all = counts.possession[0] + counts.possession[1];
  return all == 0 ? 0 : static_cast<float>(counts.possession[static_cast<int>(side)]) / static_cast<float>(all);
}

Result result_of(const State& state, const Result& decided) {
  Result result = decided;
  sum_up(state, result);
  return result;
}

Result play_on(const Params& params, State& state, Tick most) { return play_on(params, state, most, Result{}); }

void play_on(const Params& params, std::span<State> games, Tick most) {
  std::array<referee::Events, kMostGames> events;
  for (; !games.empty(); games = games.subspan(std::min(games.size(), kMostGames))) {
    std::vector<State*> playing;
    for (State& game : games.first(std::min(games.size(), kMostGames))) playing.push_back(&game);
    for (Tick tick = 0; tick < most; ++tick) {
      std::erase_if(playing, [](const State* game) { return finished(*game); });
      step_many(params, playing, {events.data(), playing.size()});
    }
  }
}

Result play_game(const Params& params, RandomKey key) {
  Result result{};
  referee::Events events;
  State state = begin(params, key, events);
  for (const referee::Event& event : events) result.count(event);
  return play_on(params, state, kNever, result);
}

std::vector<Result> play_games(const Params& params, std::span<const RandomKey> keys) {
  struct Game {
    State state;
    Result* result = nullptr;

    bool goes_on() const { return true; }
    void see(const referee::Events& events) const {
      for (const referee::Event& event : events) result->count(event);
    }
  };
  std::vector<Result> results(keys.size());
  std::vector<Game> games(std::min(keys.size(), kTogether));
  std::size_t begun = 0;
  play_many<Game>(params, games.size(), [&](Game* game) -> Game* {
    if (game != nullptr) sum_up(game->state, *game->result);
    if (begun == keys.size()) return nullptr;
    if (game == nullptr) game = &games[begun];
    game->result = &results[begun];
    referee::Events events;
    game->state = begin(params, keys[begun++], events);
    game->see(events);
    return game;
  });
  return results;
}

}  // namespace sim
