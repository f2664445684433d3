#include "sim/report/film.h"

#include <gtest/gtest.h>

#include <cmath>

#include "sim/io/matchup.h"
#include "sim/match/play.h"

namespace sim::report {
namespace {

/// Films a game of that seed until it has a window, at most one half.
Film film_of(std::uint64_t seed) {
  static const io::PreparedGame game = io::prepare({}).value();
  referee::Events events;
  State state = begin(game.params, {.seed = seed}, events);
  Film film;
  play(
      game.params, state,
      [&](const State& now) {
        film.look(now);
        return !film.windows().empty();
      },
      [](const referee::Event&) {});
  return film;
}

State known_state(Tick tick) {
  State state{};
  state.world.key = {.seed = 3};
  state.world.players = 1;
  state.world.tick = tick;
  state.book.phase = agent::Game::Phase::playing;
  state.world.ball.position = {1, 2};
  for (const Side side : {Side::home, Side::away}) state.world.bodies[robot_of(side, 1)].position = {-1, 0.5f};
  return state;
}

/// Films that state through a window; `change(state, tick)` changes it before.
template <class Change>
statistics::Window filmed(Change&& change) {
  Film film;
  for (Tick tick = 0; film.windows().empty(); ++tick) {
    State state = known_state(tick);
    change(state, tick);
    film.look(state);
  }
  return film.windows().front();
}

TEST(Film, AWindowHas5000FramesInPlay) {
  const Film film = film_of(1);
  ASSERT_EQ(film.windows().size(), 1u);
  const statistics::Window& window = film.windows().front();
  std::size_t in_play = 0;
  for (const auto& ball : window.ball) in_play += ball ? 1 : 0;
  EXPECT_EQ(in_play, statistics::kWindowFrames);
  EXPECT_TRUE(window.ball.front() && window.ball.back());
  for (const statistics::Robot& robot : window.robots) EXPECT_EQ(robot.frames.size(), window.size());
}

TEST(Film, FramesOutOfPlayAreEmpty) {
  const statistics::Window window = filmed([](State& state, Tick tick) {
    if (tick < 50 || (tick >= 100 && tick < 130)) state.book.phase = agent::Game::Phase::ready;
  });
  // those before the first one in play are left out
  EXPECT_EQ(window.size(), statistics::kWindowFrames + 30);
  EXPECT_TRUE(window.ball[49] && !window.ball[50] && !window.ball[79] && window.ball[80]);
  EXPECT_FALSE(window.robots[0].frames[60]);
}

TEST(Film, NoiseHasItsDeviation) {
  const statistics::Window window = filmed([](State&, Tick) {});
  double ball = 0, robot = 0, together = 0;
  for (std::size_t i = 0; i < window.size(); ++i) {
    const double first = static_cast<double>(window.robots[0].frames[i]->position.x) + 1;
    const double second = static_cast<double>(window.robots[1].frames[i]->position.x) + 1;
    ball += std::pow(static_cast<double>(window.ball[i]->y) - 2, 2), robot += first * first, together += first * second;
  }
  const auto count = static_cast<double>(window.size());
  EXPECT_NEAR(std::sqrt(ball / count), 0.01, 0.0005);
  EXPECT_NEAR(std::sqrt(robot / count), 0.015, 0.0008);
  EXPECT_NEAR(together / count, 0, 1e-5);
}

TEST(Film, TheSameSeedIsTheSameFilm) {
  const Film first = film_of(2), second = film_of(2);
  EXPECT_EQ(first.windows().front().ball, second.windows().front().ball);
}

TEST(Film, ARemovedRobotIsNotSeenAndAFallenOneIsDown) {
  const statistics::Window window = filmed([](State& state, Tick tick) {
    state.world.bodies[robot_of(Side::home, 1)].doing = tick < 10 ? Body::Doing::removed : Body::Doing::fallen;
  });
  EXPECT_FALSE(window.robots[0].frames[9]);
  ASSERT_TRUE(window.robots[0].frames[10]);
  EXPECT_TRUE(window.robots[0].frames[10]->down);
  EXPECT_FALSE(window.robots[1].frames[10]->down);
  EXPECT_EQ(window.robots[1].side, 1);
}

}  // namespace
}  // namespace sim::report
