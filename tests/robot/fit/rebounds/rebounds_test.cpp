#include "robot/fit/rebounds/rebounds.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <memory>

#include "robot/fit/math/resampling.h"
#include "tests/support/planted_touches.h"

namespace robot::fit {
namespace {

using tests::planted_touches, tests::PlantedTouches;

sim::Models usual_models() {
  sim::Models models{};
  models.ball.radius = 0.05f, models.ball.deceleration = 0.3f;
  models.ball.robot_restitution = models.ball.post_restitution = 0.4f;
  models.contact.foot_radius = 0.1f, models.contact.push_deviation = 0.5f;
  return models;
}

Evidence touched(std::vector<lab::TruthRecord> records) {
  Evidence evidence;
  for (lab::TruthRecord& record : records)
    evidence.games.push_back(std::make_shared<const TrueGame>(TrueGame{.name = "game", .record = std::move(record)}));
  return evidence;
}

Report fitted(const PlantedTouches& planted, std::uint64_t seed) {
  return fit_rebounds(touched({planted_touches(planted, seed)}), usual_models());
}

bool covers(const Figure* figure, double planted) {
  return figure && figure->low <= planted && planted <= figure->high;
}

TEST(TouchesIn, TheTimeThePlaceAndBothVelocitiesOfATouch) {
  const auto seen = touches_in(planted_touches({.truth_error = 0.0005, .rebounds = 8}, 1), 0.3, 3);
  ASSERT_EQ(seen.touches.size(), 8u);
  for (std::size_t i = 0; i < 8; ++i) {
    const Touch& touch = seen.touches[i];
    EXPECT_EQ(touch.recording, 3u);
    EXPECT_NEAR(touch.at, 5. * static_cast<double>(i) + 1.217, 0.02);
    ASSERT_EQ(touch.near.size(), 1u);
    EXPECT_NEAR(std::hypot(touch.x - touch.near[0].x, touch.y - touch.near[0].y), 0.15, 0.003);
    EXPECT_GT(std::hypot(touch.before_x, touch.before_y), std::hypot(touch.after_x, touch.after_y));
  }
}

TEST(TouchesIn, ImpossiblePlacesAreLeftOutAndCounted) {
  auto truth = planted_touches({.truth_error = 0.001, .rebounds = 2}, 1);
  truth.ball[10].x = NAN, truth.ball[70].y = 1e30;
  const auto seen = touches_in(truth, 0.3, 0);
  EXPECT_EQ(seen.left_out, 2u);
  EXPECT_EQ(seen.touches.size(), 2u);
}

TEST(TouchesIn, ABallThatLiesOrRollsFreelyIsNotTouched) {
  lab::TruthRecord truth;
  for (int i = 0; i < 300; ++i) truth.ball.push_back({.at = i / 30., .x = 0.1 * i / 30., .y = 1});
  EXPECT_TRUE(touches_in(truth, 0.3, 0).touches.empty());
  EXPECT_TRUE(touches_in({}, 0.3, 0).touches.empty());
}

TEST(Rebounds, TheIntervalsCoverThePlantedFiguresDespiteTheTruthsError) {
  int robots = 0, posts = 0, pushed = 0;
  for (std::uint64_t seed = 0; seed < 8; ++seed) {
    const Report report = fitted({.posts = 20, .pushes = 60}, seed);
    robots += covers(report.figure("ball.robot_restitution"), 0.5);
    posts += covers(report.figure("ball.post_restitution"), 0.6);
    pushed += covers(report.figure("contact.push_deviation"), 0.4);
  }
  EXPECT_GE(robots, 7);
  EXPECT_GE(posts, 7);
  EXPECT_GE(pushed, 7);
}

TEST(Rebounds, AMirroredFieldGivesTheSame) {
  const Report one = fitted({.posts = 12, .pushes = 40}, 1),
               other = fitted({.posts = 12, .pushes = 40, .mirrored = -1}, 1);
  ASSERT_EQ(one.figures.size(), 3u);
  ASSERT_EQ(other.figures.size(), 3u);
  for (std::size_t i = 0; i < 3; ++i) EXPECT_NEAR(one.figures[i].value, other.figures[i].value, 0.005);
}

TEST(Rebounds, TheOrderOfTheRecordingsDoesNotMatter) {
  const auto first = planted_touches({.rebounds = 12}, 1), second = planted_touches({.rebounds = 15}, 2);
  const Report one = fit_rebounds(touched({first, second}), usual_models());
  const Report other = fit_rebounds(touched({second, first}), usual_models());
  ASSERT_EQ(one.figures.size(), 1u);
  ASSERT_EQ(other.figures.size(), 1u);
  EXPECT_NEAR(one.figures[0].value, other.figures[0].value, 1e-4);
}

TEST(Rebounds, TooFewTouchesAreKeptWithTheReasonAndTheNeed) {
  const Report report = fitted({.rebounds = 3, .posts = 2, .pushes = 2}, 1);
  EXPECT_TRUE(report.empty());
  ASSERT_EQ(report.kept.size(), 3u);
  EXPECT_EQ(report.kept[0], "ball.robot_restitution: expected at least 8 rebounds off robots that stand, got 3");
  EXPECT_EQ(report.kept[1],
            "ball.post_restitution: expected at least 5 rebounds off goal posts of a known field, got 2");
  EXPECT_EQ(report.kept[2], "contact.push_deviation: expected at least 20 pushes, got 2");
  EXPECT_EQ(report.needs.size(), 3u);
  EXPECT_TRUE(fit_rebounds(Evidence{}, usual_models()).empty());
}

TEST(Rebounds, ALineBetweenTheMiddlesThatIsTooCoarseIsKept) {
  ReboundsSeen seen{.recordings = {"game"}, .robots = {}, .posts = {}, .pushes = {}};
  for (int i = 0; i < 30; ++i)
    seen.pushes.push_back({.own = 0.2, .speed = 0.3, .turn = 0.01 * i, .gap = i % 2 == 0 ? 0.08 : 0.22});
  EXPECT_EQ(fit_rebounds(seen, usual_models()).kept[2],
            "contact.push_deviation: expected a line between ball and robot that is known to 0.35 rad, got 0.69 rad");
}

TEST(Rebounds, PushesThatTheFootBendsBackAreKept) {
  ReboundsSeen seen{.recordings = {"game"}, .robots = {}, .posts = {}, .pushes = {}};
  for (int i = 0; i < 30; ++i)
    seen.pushes.push_back({.own = 0.2, .speed = 0.2, .turn = 0.02 * i, .least = -0.05, .most = 0.05, .gap = 0.15});
  EXPECT_EQ(fit_rebounds(seen, usual_models()).kept[2],
            "contact.push_deviation: expected that the foot bends back at most half of the pushes, got 27 of 30");
}

TEST(Rebounds, ARobotThatLiesOrAnotherRobotNearbyDoesNotCount) {
  auto lying = planted_touches({.rebounds = 10}, 1), crowded = lying;
  for (lab::PlaceAt& place : lying.robots[0].path) place.fallen = true;
  EXPECT_EQ(fit_rebounds(touched({lying}), usual_models()).figure("ball.robot_restitution"), nullptr);
  crowded.robots.push_back({.name = "14/3", .path = {}});
  for (lab::PlaceAt place : crowded.robots[0].path) place.x += 0.3, crowded.robots[1].path.push_back(place);
  EXPECT_LT(read_rebounds(touched({crowded}), usual_models()).robots.size(), 8u);
}

TEST(Rebounds, SingleBadReboundsHardlyCount) {
  std::vector<Rebound> rebounds;
  for (int i = 0; i < 20; ++i)
    rebounds.push_back({.in = 1, .out = 0.5 + 0.02 * (i % 3 - 1), .in_deviation = 0.03, .out_deviation = 0.03});
  rebounds.push_back({.in = 1, .out = 3, .in_deviation = 0.03, .out_deviation = 0.03});
  EXPECT_NEAR(fit_restitution(rebounds, all_of(rebounds.size()), 0), 0.5, 0.02);
}

TEST(Rebounds, TheFieldIsTheOneWhosePostsExplainMostRebounds) {
  const ReboundsSeen seen = read_rebounds(touched({planted_touches({.rebounds = 0, .posts = 16}, 1)}), usual_models());
  EXPECT_EQ(std::string(seen.posts.goals.field), "9 m x 6 m");
  EXPECT_GE(seen.posts.rebounds.size(), 12u);
}

TEST(Rebounds, APictureAndATableOfEachKindOfTouch) {
  const Report report = fitted({.posts = 12, .pushes = 40}, 1);
  EXPECT_EQ(report.pictures.size(), 3u);
  ASSERT_EQ(report.tables.size(), 3u);
  EXPECT_EQ(report.tables[0].second.rows.size(), report.figure("ball.robot_restitution")->events);
  EXPECT_NE(to_text(report).find("ball.robot_restitution"), std::string::npos);
}

}  // namespace
}  // namespace robot::fit
