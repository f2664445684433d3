#include "robot/lab/clocks/own_path.h"

#include <algorithm>
#include <cmath>
#include <memory>
#include <optional>
#include <utility>
#include <vector>

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

/// The poses, turned for one robot of the truth.
struct Candidate {
  const TrueRobotPath* robot;
  FieldPoses poses;

  /// Reports whether both were there at the same time. If not, they may be one robot that got another name.
  bool is_beside(const Candidate& other) const {
    const Path &ours = robot->path, &theirs = other.robot->path;
    return ours.front().at < theirs.back().at && theirs.front().at < ours.back().at;
  }
};

Result<OwnPath> by_pose(const TruthRecord& truth, const RobotRecord& robot, const LagRange& range) {
  std::vector<Candidate> candidates;
  for (const TrueRobotPath& candidate : truth.robots)
    if (FieldPoses poses = fit_poses(robot.poses, candidate.path, range); !poses.empty())
      candidates.push_back({.robot = &candidate, .poses = std::move(poses)});
  const auto error_of = [](const Candidate& candidate) { return candidate.poses.error; };
  const auto best = std::ranges::min_element(candidates, {}, error_of);
  if (best == candidates.end() || error_of(*best) > kNear) return Error{"its poses fit no robot of the truth"};
  for (const Candidate& other : candidates)
    if (other.robot != best->robot && other.is_beside(*best) && error_of(other) < error_of(*best) + kClearly)
      return Error{"its poses fit several robots of the truth"};
  return OwnPath{.name = best->robot->name,
                 .by = "its pose",
                 .path = continued(best->robot->path, truth, best->poses),
                 .poses = std::move(best->poses)};
}

Result<OwnPath> by_fit(const TruthRecord& truth, const RobotRecord& robot, const LagRange& range) {
  std::optional<OwnPath> best;
  double gain = 0, next_gain = 0;
  std::string reason = "the truth has no robot";
  for (const TrueRobotPath& candidate : truth.robots) {
    const auto found = find_coarse_lag(ball_distance(truth, candidate.path, robot), range);
    if (!found) {
      reason = found.error();
      continue;
    }
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
  if (auto posed = by_pose(truth, robot, range)) return posed;
  auto fitting = by_fit(truth, robot, range);
  if (!fitting) return fitting.failure();
  return with_poses(std::move(*fitting), robot, range);
}

SharedDistance ball_distance(const TruthRecord& truth, const Path& own, const RobotRecord& robot) {
  return {.truth = std::make_shared<SmoothCurve>(tidied(distances_between(truth.ball, own))), .seen = robot.ranges};
}

}  // namespace robot::lab
