#include "robot/truth/synthetic/bodies.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

namespace robot::truth {
namespace {

template <class Thing>
std::vector<Capsule> bodies_of(const Thing& thing) {
  std::vector<Capsule> bodies;
  add(thing, bodies);
  return bodies;
}

float top_of(const std::vector<Capsule>& bodies) {
  float top = 0;
  for (const Capsule& body : bodies) top = std::max(top, std::max(body.from.z(), body.to.z()) + body.radius);
  return top;
}

float bottom_of(const std::vector<Capsule>& bodies) {
  float bottom = 1;
  for (const Capsule& body : bodies) bottom = std::min(bottom, std::min(body.from.z(), body.to.z()) - body.radius);
  return bottom;
}

TEST(Bodies, ARobotThatStandsIsAsHighAsItsHeight) {
  EXPECT_NEAR(top_of(bodies_of(SceneRobot{})), static_cast<float>(kRobotHeight), 1e-3F);
}

TEST(Bodies, ARobotThatLiesIsLowAndItsMiddleIsItsPlace) {
  const std::vector<Capsule> bodies = bodies_of(SceneRobot{.x = 1, .y = -2, .heading = 0.7, .fallen = true, .arms = 0});
  EXPECT_LT(top_of(bodies), 0.25F);
  // its head is before its place and its feet are behind it, each half of its height away
  const Eigen::Vector2f heading(std::cos(0.7F), std::sin(0.7F));
  float front = 0, back = 0;
  for (const Capsule& body : bodies)
    for (const Eigen::Vector3f& end : {body.from, body.to}) {
      const float along = heading.dot(end.head<2>() - Eigen::Vector2f(1, -2));
      front = std::max(front, along + body.radius);
      back = std::min(back, along - body.radius);
    }
  EXPECT_NEAR(front, 0.29F, 1e-3F);
  EXPECT_NEAR(back, -0.29F, 1e-3F);
}

TEST(Bodies, NothingIsBelowTheCarpet) {
  for (const double arms : {0., 0.5, 1.5}) {
    EXPECT_GT(bottom_of(bodies_of(SceneRobot{.stride = 0.1, .arms = arms})), -1e-3F);
    EXPECT_GT(bottom_of(bodies_of(SceneRobot{.fallen = true, .arms = arms})), -1e-3F);
  }
  EXPECT_GT(bottom_of(bodies_of(ScenePerson{.stride = 0.3})), -1e-3F);
}

TEST(Bodies, TheLeftFootIsAStrideAheadOfTheRightOne) {
  const std::vector<Capsule> bodies = bodies_of(SceneRobot{.heading = 0, .stride = 0.1});
  const auto foot_at = [&](bool left) {
    float front = -1;
    for (const Capsule& body : bodies)
      if (body.from.z() < 0.06F && (body.from.y() > 0) == left) front = std::max(front, body.to.x());
    return front;
  };
  EXPECT_NEAR(foot_at(true) - foot_at(false), 0.1F, 1e-3F);
}

TEST(Bodies, ABallIsACapsuleOfOnePoint) {
  const std::vector<Capsule> bodies = bodies_of(SceneBall{.x = 1, .y = 2, .z = 0.3, .radius = 0.04});
  ASSERT_EQ(bodies.size(), 1U);
  EXPECT_EQ(bodies[0].from, Eigen::Vector3f(1, 2, 0.3F));
  EXPECT_EQ(bodies[0].from, bodies[0].to);
  EXPECT_EQ(bodies[0].radius, 0.04F);
}

TEST(Bodies, APersonIs1Point75MetresHigh) { EXPECT_NEAR(top_of(bodies_of(ScenePerson{})), 1.75F, 1e-3F); }

}  // namespace
}  // namespace robot::truth
