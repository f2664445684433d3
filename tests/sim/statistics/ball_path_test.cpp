#include "sim/statistics/ball_path.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "tests/sim/statistics/windows.h"

namespace sim::statistics {
namespace {

using tests::path_of;

/// A ball that rests until `at` [s], starts with `speed` [m/s] and slows by `deceleration` [m/s²].
Path rolling(double seconds, double at, double speed, double deceleration) {
  return path_of(seconds, [=](double now) -> std::optional<Vec2> {
    const double rolls = std::clamp(now - at, 0., speed / deceleration);
    return Vec2{static_cast<float>(speed * rolls - 0.5 * deceleration * rolls * rolls), 1};
  });
}

TEST(BallPath, AKickRollsAsFarAsItsDecelerationSays) {
  const Path path = smoothed(rolling(10, 2, 2, 1));
  const auto kicks = kicks_in(path, speeds_of(path));
  ASSERT_EQ(kicks.size(), 1u);
  // the speed over 0.2 s lags by 0.1 s, the median of seven frames takes a little off the peak
  EXPECT_NEAR(kicks[0].speed, 1.9, 0.08);
  // it ends where the ball is slower than 0.1 m/s: 0.1² / 2 = 5 mm before the end of 2 m
  ASSERT_TRUE(kicks[0].roll);
  EXPECT_NEAR(*kicks[0].roll, 2, 0.04);
  EXPECT_NEAR(static_cast<double>(kicks[0].frame), 2 * kFramesPerSecond, 7);
}

TEST(BallPath, AWeakPushIsNoKick) {
  const Path path = smoothed(rolling(10, 2, 0.5, 0.3));
  EXPECT_TRUE(kicks_in(path, speeds_of(path)).empty());
}

TEST(BallPath, ASteadyRollIsNoKick) {
  const Path path = smoothed(path_of(10, [](double now) { return Vec2{static_cast<float>(0.8 * now), 0}; }));
  const Speeds speeds = speeds_of(path);
  ASSERT_TRUE(speeds[100]);
  EXPECT_NEAR(*speeds[100], 0.8, 1e-4);
  EXPECT_TRUE(kicks_in(path, speeds).empty());
}

TEST(BallPath, FillsGapsOfUpTo035Seconds) {
  const auto with_gap = [](std::size_t gap) {
    Path path = path_of(4, [](double now) { return Vec2{static_cast<float>(now), 0}; });
    for (std::size_t i = 50; i < 50 + gap; ++i) path[i].reset();
    return smoothed(path);
  };
  const Path filled = with_gap(9), open = with_gap(10);
  ASSERT_TRUE(filled[54]);
  EXPECT_NEAR(filled[54]->x, 54 / 30.f, 1e-3f);
  EXPECT_FALSE(open[54]);
  EXPECT_TRUE(open[49] && open[60]);
}

TEST(BallPath, AWrongBoxDoesNotMoveTheBall) {
  Path path = rolling(4, 1, 1, 0.5);
  const Path clean = smoothed(path);
  path[60] = Vec2{-4, -3};
  const Path smooth = smoothed(path);
  EXPECT_LT(distance(*smooth[60], *clean[60]), 0.05f);
  EXPECT_LT(distance(*smooth[61], *clean[61]), 0.05f);
}

TEST(BallPath, ABallThatAHandPlacesHasNoSpeed) {
  const Path path = smoothed(path_of(4, [](double now) { return now < 2 ? Vec2{-2, 0} : Vec2{2, 0}; }));
  for (const std::optional<double>& speed : speeds_of(path)) EXPECT_TRUE(!speed || *speed < 1e-6);
}

TEST(BallPath, ARestIsLongerThanItsLimit) {
  // 12 s of rest, a roll of 2 s, 6 s of rest
  const Path path = smoothed(path_of(20, [](double now) {
    return Vec2{static_cast<float>(std::clamp(now - 12, 0., 2.)), 0};
  }));
  EXPECT_NEAR(share_at_rest(path, 10), 12. / 20, 0.02);
  EXPECT_NEAR(share_at_rest(path, 5), 18. / 20, 0.02);
  EXPECT_EQ(share_at_rest(path, 13), 0);
}

TEST(BallPath, ARestGoesOnWhileTheBallIsHidden) {
  Path path = path_of(16, [](double) { return Vec2{1, 1}; });
  for (std::size_t i = 200; i < 280; ++i) path[i].reset();
  EXPECT_DOUBLE_EQ(share_at_rest(smoothed(path), 10), 1);
}

TEST(BallPath, DisplacementIsBetweenTwoTimes) {
  const Path path = path_of(60, [](double now) { return Vec2{static_cast<float>(0.1 * now), 0}; });
  EXPECT_NEAR(displacement_after(path, 10), 1, 1e-5);
  EXPECT_NEAR(displacement_after(path, 30), 3, 1e-5);
  EXPECT_TRUE(std::isnan(displacement_after(path, 90)));
}

}  // namespace
}  // namespace sim::statistics
