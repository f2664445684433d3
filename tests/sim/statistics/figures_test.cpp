#include "sim/statistics/figures.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <string>

#include "tests/sim/statistics/windows.h"

namespace sim::statistics {
namespace {

std::map<std::string, double> all_of(const Figures& figures) {
  std::map<std::string, double> all;
  Figures::visit(figures, [&](const char* key, double value, const char*, const char*) { all[key] = value; });
  return all;
}

/// Expects equal figures, but for the rounding of positions.
void expect_equal(const Figures& one, const Figures& two) {
  const auto second = all_of(two);
  for (const auto& [key, value] : all_of(one)) EXPECT_NEAR(value, second.at(key), 1e-4) << key;
}

template <class Change>
Window changed(Window window, Change&& change) {
  for (auto& ball : window.ball)
    if (ball) ball = change(*ball);
  for (Robot& robot : window.robots)
    for (auto& seen : robot.frames)
      if (seen) seen->position = change(seen->position);
  return window;
}

TEST(Figures, MeasuresAllOfASmallGame) {
  for (const auto& [key, value] : all_of(measure(tests::small_game()))) EXPECT_TRUE(std::isfinite(value)) << key;
}

TEST(Figures, ASmallGameHasItsKnownFigures) {
  const Figures figures = measure(tests::small_game());
  // kicks at 12, 24, 36 and 48 s; the one at 0 s has no time before it
  EXPECT_NEAR(figures.kicks, 4, 0.02);
  EXPECT_EQ(figures.fast_kick_share, 1);
  EXPECT_NEAR(figures.roll_median, 1.44, 0.05);
  EXPECT_NEAR(figures.ball_speed, 1.44 * 5 / 60, 0.005);
  EXPECT_NEAR(figures.walking_median, 0.15, 0.001);
  EXPECT_NEAR(figures.walked, 9, 0.05);
  EXPECT_NEAR(figures.falls, 2. / 8, 1e-6);
  EXPECT_NEAR(figures.middle, 0.478, 0.01);
}

TEST(Figures, KnownDistances) {
  Window window;
  window.ball = Path(100, Vec2{0, 0});
  const auto add = [&](int side, int player, Vec2 place) {
    window.robots.push_back(
        tests::robot_of(side, player, 100. / kFramesPerSecond, [=](double) { return Sighting{.position = place}; }));
  };
  add(0, 1, {-4, 0}), add(0, 2, {-0.5, 0}), add(0, 3, {-1, 0}), add(0, 4, {-2, 1});
  add(1, 1, {4, 0}), add(1, 2, {0.7f, 0}), add(1, 3, {0.7f, 0.3f}), add(1, 4, {2, 2});
  const Figures figures = measure(window);
  EXPECT_NEAR(figures.nearest, 0.5, 1e-6);
  EXPECT_NEAR(figures.second, 0.7, 1e-6);
  EXPECT_NEAR(figures.third, std::hypot(0.7, 0.3), 1e-6);
  EXPECT_EQ(figures.nobody_1m, 0);
  EXPECT_EQ(figures.both_60cm, 0);
  EXPECT_EQ(figures.both_1m, 1);
  EXPECT_EQ(figures.middle, 1);
  EXPECT_NEAR(figures.close, 2. / 8, 1e-9);  // two opponents, 0.3 m apart
  EXPECT_NEAR(figures.extent_x, (1.5 + 1.3) / 2, 1e-6);
  EXPECT_NEAR(figures.extent_y, (1. + 2.) / 2, 1e-6);
}

TEST(Figures, AMirroredFieldGivesTheSame) {
  const Window window = tests::small_game();
  const Figures figures = measure(window);
  expect_equal(figures, measure(changed(window, [](Vec2 place) { return Vec2{-place.x, place.y}; })));
  expect_equal(figures, measure(changed(window, [](Vec2 place) { return Vec2{place.x, -place.y}; })));
}

TEST(Figures, SwappedSidesGiveTheSame) {
  Window window = tests::small_game();
  const Figures figures = measure(window);
  for (Robot& robot : window.robots) robot.side = 1 - robot.side;
  std::reverse(window.robots.begin(), window.robots.end());
  expect_equal(figures, measure(window));
}

TEST(Figures, NoiseOfACameraChangesLittle) {
  const Window window = tests::small_game();
  const Figures clean = measure(window), noisy = measure(tests::with_noise(window, 0.015f));
  const auto measured = all_of(noisy);
  EXPECT_NEAR(noisy.kicks, clean.kicks, 0.05);
  EXPECT_NEAR(noisy.fast_kicks, clean.fast_kicks, 0.05);
  for (const char* key :
       {"roll_median", "ball_speed", "nearest", "second", "third", "mates", "extent_x", "walking_median"})
    EXPECT_NEAR(measured.at(key), all_of(clean).at(key), 0.05) << key;
  EXPECT_NEAR(noisy.ball_still, clean.ball_still, 0.01);
  EXPECT_EQ(noisy.falls, clean.falls);
}

TEST(Figures, GapsChangeLittle) {
  Window window = tests::small_game();
  const Figures clean = measure(window);
  // every fourth frame has no ball, and a robot is hidden for a third of the time
  for (std::size_t i = 0; i < window.size(); ++i) {
    if (i % 4 == 3) window.ball[i].reset();
    if (i % 300 < 100) window.robots[3].frames[i].reset();
  }
  const Figures gappy = measure(window);
  EXPECT_NEAR(gappy.kicks, clean.kicks, 0.05);
  EXPECT_NEAR(gappy.ball_speed, clean.ball_speed, 0.005);
  EXPECT_NEAR(gappy.walked, clean.walked, 0.05);
  EXPECT_NEAR(gappy.mates, clean.mates, 0.1);
}

TEST(Figures, AnEmptyWindowIsNotMeasured) {
  for (const auto& [key, value] : all_of(measure({}))) EXPECT_TRUE(std::isnan(value)) << key;
}

}  // namespace
}  // namespace sim::statistics
