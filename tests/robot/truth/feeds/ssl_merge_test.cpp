// Views of several cameras become one world: one thing that two cameras see is one thing.
#include "robot/truth/feeds/ssl_merge.h"

#include <gtest/gtest.h>

#include <cmath>

namespace robot::truth {
namespace {

constexpr double kPi = 3.14159265358979323846;

TEST(SslMerge, AThingThatTwoCamerasSeeIsOneAndItsPlaceIsTheMean) {
  const auto truth = merge({{.camera = 0,
                             .balls = {{.x = 1.00, .y = 0.50, .confidence = 0.6}},
                             .robots = {{.team = 14, .player = 2, .x = 2.00, .heading = 0.1, .confidence = 0.3}}},
                            {.camera = 1,
                             .balls = {{.x = 1.02, .y = 0.50, .confidence = 0.6}},
                             .robots = {{.team = 14, .player = 2, .x = 2.08, .heading = 0.3, .confidence = 0.9}}}},
                           std::nullopt);
  EXPECT_NEAR(truth.ball().x(), 1.01, 1e-6);
  EXPECT_NEAR(truth.ball().y(), 0.5, 1e-6);
  EXPECT_FLOAT_EQ(truth.ball().confidence(), 0.6F);
  EXPECT_EQ(truth.ball().sensors(), 2u);
  ASSERT_EQ(truth.robots_size(), 1);
  EXPECT_EQ(truth.robots(0).team(), 14u);
  EXPECT_EQ(truth.robots(0).player(), 2u);
  EXPECT_NEAR(truth.robots(0).x(), 2.06, 1e-4);  // three quarters of the weight
  EXPECT_NEAR(truth.robots(0).heading(), 0.25, 1e-3);
  EXPECT_FLOAT_EQ(truth.robots(0).confidence(), 0.9F);
  EXPECT_EQ(truth.robots(0).sensors(), 2u);
  EXPECT_EQ(truth.disagreements_size(), 0);
}

TEST(SslMerge, OneCameraIsPassedOnAsItIs) {
  const auto truth = merge({{.camera = 4, .robots = {{.team = 5, .x = -1.5, .y = 2.25, .confidence = 0.5}}}}, {});
  EXPECT_FALSE(truth.has_ball());
  ASSERT_EQ(truth.robots_size(), 1);
  EXPECT_FLOAT_EQ(truth.robots(0).x(), -1.5F);
  EXPECT_FLOAT_EQ(truth.robots(0).y(), 2.25F);
  EXPECT_FALSE(truth.robots(0).has_player());
  EXPECT_FALSE(truth.robots(0).has_heading());
  EXPECT_EQ(truth.robots(0).sensors(), 1u);
}

TEST(SslMerge, TheMeanOfHeadingsWorksAcrossHalfATurn) {
  const auto truth =
      merge({{.camera = 0, .robots = {{.team = 1, .player = 1, .heading = kPi - 0.1, .confidence = 1}}},
             {.camera = 1, .robots = {{.team = 1, .player = 1, .heading = -kPi + 0.1, .confidence = 1}}}},
            {});
  EXPECT_NEAR(std::abs(truth.robots(0).heading()), kPi, 1e-5);
}

TEST(SslMerge, TheSamePlayerFartherApartIsADisagreementAndTheMostConfidentOneCounts) {
  const auto truth =
      merge({{.camera = 0, .robots = {{.team = 14, .player = 2, .x = 1, .y = 1, .confidence = 0.5}}},
             {.camera = 1, .robots = {{.team = 14, .player = 2, .x = 1.3, .y = 1.4, .confidence = 0.8}}}},
            {});
  ASSERT_EQ(truth.robots_size(), 1);
  EXPECT_FLOAT_EQ(truth.robots(0).x(), 1.3F);
  EXPECT_EQ(truth.robots(0).sensors(), 1u);
  ASSERT_EQ(truth.disagreements_size(), 1);
  EXPECT_EQ(truth.disagreements(0),
            "robot 14/2: camera 1 sees it at (1.30, 1.40), camera 0 at (1.00, 1.00), 0.50 m apart");
}

TEST(SslMerge, ARobotWithoutANumberJoinsTheNumberedOneAtItsPlace) {
  const auto truth = merge(
      {{.camera = 0, .robots = {{.team = 14, .x = 1.05, .confidence = 0.9}}},
       {.camera = 1,
        .robots = {{.team = 14, .player = 3, .x = 1, .confidence = 0.5}, {.team = 5, .x = 1.05, .confidence = 0.5}}}},
      {});
  ASSERT_EQ(truth.robots_size(), 2);
  EXPECT_EQ(truth.robots(0).player(), 3u);
  EXPECT_EQ(truth.robots(0).sensors(), 2u);
  EXPECT_FLOAT_EQ(truth.robots(0).confidence(), 0.9F);
  EXPECT_EQ(truth.robots(1).team(), 5u);  // another team is another robot
}

TEST(SslMerge, NeighboursStayApart) {
  const auto truth = merge({{.camera = 0,
                             .robots = {{.team = 14, .player = 1, .x = 0, .confidence = 1},
                                        {.team = 14, .player = 2, .x = 0.05, .confidence = 1},
                                        {.team = 5, .x = 1, .confidence = 1},
                                        {.team = 5, .x = 1.18, .confidence = 1}}}},
                           {});
  EXPECT_EQ(truth.robots_size(), 4);
}

TEST(SslMerge, TheBallIsTheMostConfidentOneWithinTheBorder) {
  const std::vector<SslView> views = {{.camera = 0,
                                       .balls = {{.x = 0.5, .y = 0, .confidence = 0.7},
                                                 {.x = 4.9, .y = 0, .confidence = 0.9},
                                                 {.x = -2, .y = 1, .confidence = 0.8}}}};
  EXPECT_FLOAT_EQ(merge(views, std::nullopt).ball().x(), 4.9F);
  const SslField field{.length = 9, .width = 6, .border = 0.3};
  EXPECT_FLOAT_EQ(merge(views, field).ball().x(), -2);
  EXPECT_FALSE(merge({{.camera = 0, .balls = {{.x = 0, .y = 3.4, .confidence = 1}}}}, field).has_ball());
}

TEST(SslMerge, TheOrderOfTheCamerasDoesNotMatter) {
  const SslView one{
      .camera = 0,
      .balls = {{.x = 1, .confidence = 0.5}, {.x = 3, .confidence = 0.2}},
      .robots = {{.team = 1, .player = 1, .x = 2, .confidence = 0.6}, {.team = 1, .x = -2, .confidence = 0.3}}};
  const SslView two{.camera = 1,
                    .balls = {{.x = 1.03, .confidence = 0.9}},
                    .robots = {{.team = 1, .player = 1, .x = 2.5, .confidence = 0.7}}};
  EXPECT_EQ(merge({one, two}, {}).SerializeAsString(), merge({two, one}, {}).SerializeAsString());
}

TEST(SslMerge, AConfidenceOfZeroStillHasAPlace) {
  const auto truth = merge({{.camera = 0, .balls = {{.x = 1, .y = 2, .confidence = 0}}}}, {});
  EXPECT_FLOAT_EQ(truth.ball().x(), 1);
  EXPECT_FLOAT_EQ(truth.ball().y(), 2);
}

}  // namespace
}  // namespace robot::truth
