#include "robot/truth/tracks/joining.h"

#include <gtest/gtest.h>

#include "tests/robot/truth/tracks/images.h"

namespace robot::truth {
namespace {

/// Returns the trail of a robot that stands at x for a second.
RobotTrail standing(std::uint32_t track, double begin, double x) {
  RobotTrail trail;
  trail.trail.track = track;
  for (int i = 0; i < 30; ++i)
    trail.trail.moments.push_back(
        {.capture_ns = at_seconds(begin + i / 30.), .track = track, .measurement = Measurement{0, seen_at(x, 0)}});
  return trail;
}

const std::vector<Sensor> kOneSensor{sensor_beside(0)};

TEST(JoinBroken, JoinsTwoTrailsWhereTheRobotCanHaveWalked) {
  std::vector<RobotTrail> trails{standing(1, 0, 0), standing(2, 8, 1)};
  join_broken(trails, kOneSensor);
  ASSERT_EQ(trails.size(), 1u);
  EXPECT_EQ(trails[0].trail.track, 1u);
  EXPECT_EQ(trails[0].trail.moments.size(), 60u);
}

TEST(JoinBroken, JoinsAChain) {
  std::vector<RobotTrail> trails{standing(1, 0, 0), standing(2, 8, 1), standing(3, 20, 0)};
  join_broken(trails, kOneSensor);
  ASSERT_EQ(trails.size(), 1u);
  EXPECT_EQ(trails[0].trail.moments.size(), 90u);
}

TEST(JoinBroken, LeavesTrailsThatFitToSeveral) {
  std::vector<RobotTrail> two_ends{standing(1, 0, 0), standing(2, 0, 0.5), standing(3, 8, 0.2)};
  join_broken(two_ends, kOneSensor);
  EXPECT_EQ(two_ends.size(), 3u);
  std::vector<RobotTrail> two_beginnings{standing(1, 0, 0), standing(2, 8, 0.5), standing(3, 8, -0.2)};
  join_broken(two_beginnings, kOneSensor);
  EXPECT_EQ(two_beginnings.size(), 3u);
}

TEST(JoinBroken, LeavesTrailsThatAreTooFarInTimeOrPlace) {
  std::vector<RobotTrail> late{standing(1, 0, 0), standing(2, 17, 0)}, far{standing(1, 0, 0), standing(2, 3, 3)},
      overlapping{standing(1, 0, 0), standing(2, 0.5, 0)};
  for (std::vector<RobotTrail>* trails : {&late, &far, &overlapping}) {
    join_broken(*trails, kOneSensor);
    EXPECT_EQ(trails->size(), 2u);
  }
}

TEST(JoinBroken, LeavesTrailsOfTwoPlayers) {
  std::vector<RobotTrail> trails{standing(1, 0, 0), standing(2, 8, 0)};
  trails[0].player = 0;
  trails[1].player = 1;
  join_broken(trails, kOneSensor);
  EXPECT_EQ(trails.size(), 2u);
  trails[1].player.reset();
  join_broken(trails, kOneSensor);
  ASSERT_EQ(trails.size(), 1u);
  EXPECT_EQ(trails[0].player, 0u);
}

}  // namespace
}  // namespace robot::truth
