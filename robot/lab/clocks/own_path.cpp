#include "robot/lab/clocks/own_path.h"

#include <algorithm>
#include <cmath>
#include <memory>
#include <optional>
#include <utility>

namespace robot::lab {
namespace {

constexpr double kNear = 0.5;        // [m] mean error of poses that belong to a path
constexpr double kClearly = 0.1;     // [m] the next path is further away than that
constexpr double kClearGain = 1.25;  // likewise, of the gains of two paths

/// Returns the place of the truth's robot that is closest to the pose, at most kNear away.
std::optional<PlaceAt> place_near(const TruthRecord& truth, const PoseBelief& pose, double at) {
  std::optional<PlaceAt> nearest;
  double least = kNear;
  for (const TrueRobotPath& robot : truth.robots)
    if (const auto place = place_at(robot.path, at)) {
      const double far = std::hypot(place->x - pose.x, place->y - pose.y);
      if (far < least) least = far, nearest = place;
    }
  return nearest;
}

/// Returns the path with the places that other names hold while it has none.
Path continued(Path path, const TruthRecord& truth, const FieldPoses& poses) {
  Path added;
  for (const PoseBelief& pose : poses.poses)
    if (const double at = pose.at - poses.lag; !place_at(path, at))
      if (const auto place = place_near(truth, pose, at)) added.push_back(*place);
  path.insert(path.end(), added.begin(), added.end());
  std::ranges::stable_sort(path, {}, &PlaceAt::at);
  return path;
}

Result<OwnPath> by_pose(const TruthRecord& truth, const RobotRecord& robot, const LagRange& range) {
  std::optional<OwnPath> best;
  double next_error = INFINITY;
  for (const TrueRobotPath& candidate : truth.robots) {
    FieldPoses poses = fit_poses(robot.poses, candidate.path, range);
    if (poses.empty()) continue;
    if (best && poses.error >= best->poses.error) {
      next_error = std::min(next_error, poses.error);
      continue;
    }
    if (best) next_error = best->poses.error;
    best = OwnPath{.name = candidate.name, .by = "its pose", .path = candidate.path, .poses = std::move(poses)};
  }
  if (!best || best->poses.error > kNear) return Error{"its poses fit no robot of the truth"};
  if (next_error < best->poses.error + kClearly) return Error{"its poses fit several robots of the truth"};
  return std::move(*best);
}

Result<OwnPath> by_fit(const TruthRecord& truth, const RobotRecord& robot, const LagRange& range) {
  std::optional<OwnPath> best;
  double gain = 0, next_gain = 0;
  std::string reason = "the truth has no robot";
  for (const TrueRobotPath& candidate : truth.robots) {
    const auto found = find_coarse_lag({ball_distance(truth, candidate.path, robot)}, range);
    if (!found) reason = found.error();
    if (!found) continue;
    next_gain = std::max(next_gain, std::min(gain, found->gain));
    if (found->gain <= gain) continue;
    gain = found->gain;
    best = OwnPath{.name = candidate.name, .by = "the best fit", .path = candidate.path, .poses = {}};
  }
  if (!best) return Error{reason};
  if (gain < kClearGain * next_gain)
    return Error{"the distances of the ball fit several robots of the truth, and their numbers are not known"};
  return std::move(*best);
}

/// Adds the poses in the frame of the truth, if they fit.
OwnPath with_poses(OwnPath own, const RobotRecord& robot, const LagRange& range) {
  FieldPoses poses = fit_poses(robot.poses, own.path, range);
  if (poses.error <= kNear) own.poses = std::move(poses);
  return own;
}

}  // namespace

Result<OwnPath> own_path(const TruthRecord& truth, const RobotRecord& robot, const LagRange& range) {
  const auto numbered = std::ranges::find(truth.robots, robot.name, &TrueRobotPath::name);
  if (numbered != truth.robots.end())
    return with_poses({.name = numbered->name, .by = "its number", .path = numbered->path, .poses = {}}, robot, range);
  if (truth.robots.size() == 1)
    return with_poses({.name = truth.robots[0].name, .by = "the only robot", .path = truth.robots[0].path, .poses = {}},
                      robot, range);
  if (auto posed = by_pose(truth, robot, range)) {
    posed->path = continued(std::move(posed->path), truth, posed->poses);
    return posed;
  }
  auto fitting = by_fit(truth, robot, range);
  if (!fitting) return fitting.failure();
  return with_poses(std::move(*fitting), robot, range);
}

SharedQuantity ball_distance(const TruthRecord& truth, const Path& own, const RobotRecord& robot) {
  constexpr double kGrowsFrom = 0.5;  // [m]
  return {.truth = std::make_shared<SmoothCurve>(tidied(distances_between(truth.ball, own))),
          .robot = robot.ranges,
          .grows_from = kGrowsFrom};
}

}  // namespace robot::lab
