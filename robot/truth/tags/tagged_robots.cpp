#include "robot/truth/tags/tagged_robots.h"

#include <Eigen/LU>
#include <algorithm>
#include <cmath>
#include <cstddef>
#include <numbers>
#include <optional>
#include <utility>

#include "robot/truth/tags/tag_pose.h"

namespace robot::truth::tags {
namespace {

constexpr double kMostCost = 35;  // of a right pose; a head that is bent by 25 degrees costs 25
constexpr double kStandsBelow = 45 * std::numbers::pi / 180;  // [rad] a robot of more tilt has fallen

double wrapped(double angle) { return std::remainder(angle, 2 * std::numbers::pi); }

/// Returns the robot whose tag has this pose: the tag's place minus its mounting.
SeenRobot standing_robot(const TagPose& pose, const Mounting& mounting) {
  const Eigen::Vector3d upper = pose.upper_edge();
  const double heading = wrapped(std::atan2(upper.y(), upper.x()) - mounting.turn);
  const double c = std::cos(heading), s = std::sin(heading);
  const Eigen::Vector2d offset{c * mounting.forward - s * mounting.left, s * mounting.forward + c * mounting.left};
  // the derivative of the place by the tag's centre and by its turn about the vertical
  Eigen::Matrix<double, 2, 6> derivative = Eigen::Matrix<double, 2, 6>::Zero();
  derivative.leftCols<2>().setIdentity();
  derivative.col(5) << offset.y(), -offset.x();

  SeenRobot robot;
  robot.place.position = pose.field_from_tag.translation().head<2>() - offset;
  robot.place.covariance = derivative * pose.covariance * derivative.transpose();
  robot.height = pose.height();
  robot.heading = heading;
  robot.heading_deviation = std::sqrt(pose.covariance(5, 5));
  return robot;
}

SeenRobot lying_robot(const TagPose& pose) {
  SeenRobot robot;
  robot.place.position = pose.field_from_tag.translation().head<2>();
  robot.place.covariance = pose.covariance.topLeftCorner<2, 2>();
  robot.height = std::max(0.0, pose.height());
  return robot;
}

bool stands(const TagPose& pose) { return pose.cost <= kMostCost && pose.tilt() < kStandsBelow; }

bool lies(const TagPose& pose, const Mounting& mounting) {
  constexpr double kLowest = -0.08;  // [m] as exact as a height without a prior is
  return pose.cost <= kMostCost && pose.tilt() >= kStandsBelow && pose.height() > kLowest &&
         pose.height() < mounting.height / 2;
}

SeenRobot identified(SeenRobot robot, const TaggedRobot& carrier) {
  robot.team = carrier.team;
  robot.player = carrier.player;
  return robot;
}

std::optional<SeenRobot> robot_of(const Camera& camera, const SeenTag& tag, const TaggedRobot& carrier) {
  const Mounting& mounting = carrier.mounting;
  const auto upright = standing_pose(camera, tag.corners, mounting.edge, mounting.height);
  if (upright && stands(*upright)) return identified(standing_robot(*upright, mounting), carrier);
  const auto fallen = free_pose(camera, tag.corners, mounting.edge);
  if (fallen && lies(*fallen, mounting)) return identified(lying_robot(*fallen), carrier);
  return std::nullopt;
}

bool agree(const SeenRobot& one, const SeenRobot& other) {
  constexpr double kFarthest = 0.15;                         // [m]
  constexpr double kMostTurn = 20 * std::numbers::pi / 180;  // [rad]
  if ((one.place.position - other.place.position).norm() > kFarthest) return false;
  if (one.heading.has_value() != other.heading.has_value()) return false;
  return !one.heading || std::abs(wrapped(*one.heading - *other.heading)) < kMostTurn;
}

/// Merges two measurements of the same robot, each weighted by its covariance.
SeenRobot merged(const SeenRobot& one, const SeenRobot& other) {
  SeenRobot robot = one;
  const Eigen::Matrix2d gain = one.place.covariance * (one.place.covariance + other.place.covariance).inverse();
  robot.place.position += gain * (other.place.position - one.place.position);
  robot.place.covariance -= gain * one.place.covariance;
  robot.height = std::max(one.height, other.height);
  if (!one.heading) return robot;
  const double variance = *one.heading_deviation * *one.heading_deviation;
  const double other_variance = *other.heading_deviation * *other.heading_deviation;
  const double share = variance / (variance + other_variance);
  robot.heading = wrapped(*one.heading + share * wrapped(*other.heading - *one.heading));
  robot.heading_deviation = std::sqrt(variance * (1 - share));
  return robot;
}

/// All measurements of one robot in a picture.
struct Measured {
  SeenRobot robot;
  std::uint64_t tags = 1;
  bool contradicted = false;
};

void add(std::vector<Measured>& measured, const SeenRobot& robot) {
  for (Measured& known : measured) {
    if (known.robot.team != robot.team || known.robot.player != robot.player) continue;
    ++known.tags;
    if (known.contradicted || !agree(known.robot, robot))
      known.contradicted = true;
    else
      known.robot = merged(known.robot, robot);
    return;
  }
  measured.push_back({.robot = robot});
}

}  // namespace

std::vector<SeenRobot> tagged_robots(const Camera& camera, const TagPlan& plan, const std::vector<SeenTag>& tags,
                                     RefusedTags& refused) {
  std::vector<Measured> measured;
  for (const SeenTag& tag : tags) {
    const auto carrier = plan.tags.find(tag.id);
    const auto same = [&](const SeenTag& other) { return other.id == tag.id; };
    if (carrier == plan.tags.end())
      ++refused.unknown;
    else if (std::count_if(tags.begin(), tags.end(), same) > 1)
      ++refused.repeated;
    else if (const auto robot = robot_of(camera, tag, carrier->second))
      add(measured, *robot);
    else
      ++refused.implausible;
  }
  std::vector<SeenRobot> robots;
  for (const Measured& each : measured) {
    if (each.contradicted)
      refused.contradictory += each.tags;
    else
      robots.push_back(each.robot);
  }
  return robots;
}

}  // namespace robot::truth::tags
