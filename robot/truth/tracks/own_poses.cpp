#include "robot/truth/tracks/own_poses.h"

#include <algorithm>
#include <cmath>

#include "robot/core/text.h"
#include "robot/truth/tracks/times.h"

namespace robot::truth {
namespace {

constexpr double kLargestAge = 0.15;  // [s]

}  // namespace

Result<void> valid(const OwnPose& pose) {
  if (pose.position.allFinite() && std::isfinite(pose.deviation) && pose.deviation > 0) return {};
  return Error{
      formatted("own pose of team %u, player %u: expected a finite place and a deviation > 0 m, got (%g, %g) m, %g m",
                pose.team, pose.player, pose.position.x(), pose.position.y(), pose.deviation)};
}

std::optional<std::size_t> OwnPoses::find(std::uint32_t team, std::uint32_t player) const {
  const auto found = std::find_if(players_.begin(), players_.end(),
                                  [&](const Player& known) { return known.team == team && known.number == player; });
  if (found == players_.end()) return std::nullopt;
  return static_cast<std::size_t>(found - players_.begin());
}

std::optional<std::size_t> OwnPoses::find_or_add(std::uint32_t team, std::uint32_t player) {
  if (const auto found = find(team, player)) return found;
  if (players_.size() == kMostPlayers) return std::nullopt;
  players_.push_back({.team = team, .number = player, .poses = {}, .added = 0});
  return players_.size() - 1;
}

Result<void> OwnPoses::add(const OwnPose& pose) {
  if (const Result<void> checked = valid(pose); !checked) return checked.failure();
  const std::optional<std::size_t> index = find_or_add(pose.team, pose.player);
  if (!index)
    return Error{formatted("own pose of team %u, player %u: expected at most %zu players in all", pose.team,
                           pose.player, kMostPlayers)};
  Player& player = players_[*index];
  player.poses[player.added++ % player.poses.size()] = pose;
  return {};
}

const OwnPose* OwnPoses::Player::at(std::uint64_t capture_ns) const {
  const OwnPose* nearest = nullptr;
  double least = kLargestAge;
  for (std::size_t i = 0; i < std::min(added, poses.size()); ++i) {
    const double age = std::abs(seconds_between(poses[i].capture_ns, capture_ns));
    if (age <= least) {
      least = age;
      nearest = &poses[i];
    }
  }
  return nearest;
}

}  // namespace robot::truth
