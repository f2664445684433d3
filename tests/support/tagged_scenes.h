// Random scenes of tagged robots under a camera, with their truth.
#pragma once

#include <Eigen/Core>
#include <cstdint>
#include <random>
#include <vector>

#include "robot/truth/tags/tag_plan.h"
#include "tests/support/rendered_pictures.h"

namespace tests {

struct TrueRobot {
  std::uint32_t team = 0, player = 0;
  Eigen::Vector2d place = Eigen::Vector2d::Zero();  // [m] between the feet; of a lying robot below its tag
  double heading = 0;                               // [rad]
  bool lies = false;
  Eigen::Isometry3d field_from_tag = Eigen::Isometry3d::Identity();
  double edge = 0;       // [m] of its tag
  bool touched = false;  // something is near the tag and may hide it
};

struct TaggedScene {
  Things things;
  Conditions conditions;
  std::vector<TrueRobot> robots;  // whose tags the plan has
  Eigen::Vector2d ball = Eigen::Vector2d::Zero();
};

inline constexpr double kSceneBallRadius = 0.0325;  // [m]

/// Returns the plan of ten robots in the teams 5 and 18. Their tags have edges of 12 to 16 cm and are 0.45 or 0.58 m high,
/// ahead of or beside the robot's middle and turned by quarters.
robot::truth::tags::TagPlan plan_of_scenes();

/// Returns a camera of 1280x720 px at 2.5 to 3 m height. It looks at 5 x 4 m of the field around the origin, through a
/// wide lens with distortion.
robot::truth::tags::Camera random_camera(std::mt19937& random);

/// Returns about six robots on 4.4 x 3.2 m, at least 0.4 m apart. They sway by 2° and 5 mm. One of 30 lies; an arm is near
/// one of 10 tags and may hide a part of it. One more tag is not in the plan. A ball lies between the robots.
TaggedScene random_scene(std::mt19937& random);

/// Reports whether the middle of the ball's picture is within the picture and not hidden.
bool shows_ball(const TaggedScene& scene, const robot::truth::tags::Camera& camera);

}  // namespace tests
