#include "sim/check/measure.h"

#include <gtest/gtest.h>

#include <random>

#include "tests/sim/check/course.h"

namespace sim::check {
namespace {

/// Measures a course in which we touch the ball after 2 s and 6 s, and the ball goes to x = 1, -2 and 0.5 m.
std::optional<double> measured(std::string_view text) {
  const auto metric = parse_metric(text);
  EXPECT_TRUE(metric) << text << ": " << metric.error();
  if (!metric) return {};
  Measure measure(*metric);
  Course course;
  const auto see = [&](const Glance& glance) { measure.see(glance); };
  course.wait(2, see);
  course.touch(Side::home, 2, see);
  for (const float x : {1.f, -2.f, 0.5f}) {
    course.now().world.ball.position.x = x;
    course.wait(2, see);
  }
  course.touch(Side::home, 3, see);
  return measure.value();
}

std::string refused_metric(std::string_view text) {
  const auto metric = parse_metric(text);
  return metric ? "accepted" : metric.error();
}

TEST(Measure, AConditionIsOneOrZero) {
  EXPECT_EQ(measured("our touch"), 1);
  EXPECT_EQ(measured("our touch then our touch within 5 s"), 0);
  EXPECT_EQ(measured("never their touch"), 1);
}

TEST(Measure, TimeOfIsTheFirstTickInWhichTheFactHolds) {
  EXPECT_NEAR(measured("time of our touch").value(), 2, 0.1);
  EXPECT_NEAR(measured("time of ball_x < -1 m").value(), 4, 0.1);
  EXPECT_FALSE(measured("time of their touch"));
}

TEST(Measure, CountOfIsTheNumberOfHappenings) {
  EXPECT_EQ(measured("count of our touch"), 2);
  EXPECT_EQ(measured("count of their touch"), 0);
}

TEST(Measure, LeastMostAndFinalAreThoseOfAllTicks) {
  EXPECT_EQ(measured("least ball_x"), -2);
  EXPECT_EQ(measured("most ball_x"), 1);
  EXPECT_EQ(measured("final ball_x"), 0.5);
}

TEST(Measure, FlippedBytesAreAcceptedOrRefusedWithASentence) {
  std::mt19937 random(1);
  const std::string texts[] = {"not always ball_x > 1 m or our touch then our touch within 5 s and never their goal",
                               "time of ball_speed >= 0.5 m/s", "count of our pass", "least their_ball_distance"};
  for (const std::string& text : texts)
    for (int n = 0; n < 500; ++n) {
      std::string flipped = text;
      flipped[random() % flipped.size()] = static_cast<char>(random());
      EXPECT_NE(refused_metric(flipped), "") << flipped;
    }
}

TEST(Measure, NamesTheError) {
  EXPECT_EQ(refused_metric("most bal_x"), "expected a happening or a quantity, got \"bal_x\"; did you mean 'ball_x'?");
  EXPECT_EQ(refused_metric("most ball_x now"), "expected the end of the metric, got 'now'");
  EXPECT_EQ(refused_metric("count of ball_x > 1"), "'count of' takes a happening, got a comparison");
  EXPECT_EQ(refused_metric("time of our touch then our touch"), "expected the end of the metric, got 'then our touch'");
  EXPECT_EQ(refused_metric(std::string(2000, 'x')), "must have at most 1000 bytes, got 2000");
}

}  // namespace
}  // namespace sim::check
