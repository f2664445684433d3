// The places where robots believe to be, from their recordings or live.
#pragma once

#include <Eigen/Core>
#include <array>
#include <cstdint>
#include <optional>
#include <vector>

#include "robot/core/result.h"

namespace robot::truth {

/// Most players of a recording: two teams of up to 11 with substitutes.
constexpr std::size_t kMostPlayers = 32;

/// The place where one robot believes to be. It may be wrong, or on the wrong half of the field.
struct OwnPose {
  std::uint64_t capture_ns = 0;  // on the clock of the sensors
  std::uint32_t team = 0, player = 0;
  Eigen::Vector2d position = Eigen::Vector2d::Zero();  // [m, field]
  double deviation = 0.2;                              // [m] one standard deviation along an axis, > 0
};

/// Returns an Error if a number of the pose is not finite, or its deviation is not positive.
Result<void> valid(const OwnPose& pose);

/// The newest own poses of each player. Bounded memory.
class OwnPoses {
 public:
  /// Returns the index of a player in players(), or nothing if it is not known.
  std::optional<std::size_t> find(std::uint32_t team, std::uint32_t player) const;

  /// Works as find(), but a new player becomes known. Returns nothing for player kMostPlayers + 1.
  std::optional<std::size_t> find_or_add(std::uint32_t team, std::uint32_t player);

  /// Keeps the pose, and at least the 63 before it of the same player. Returns an Error if it is not valid, or if there are
  /// too many players. A pose may be older than earlier ones.
  Result<void> add(const OwnPose& pose);

  struct Player {
    std::uint32_t team = 0, number = 0;
    std::array<OwnPose, 64> poses;
    std::size_t added = 0;

    /// Returns the pose nearest in time, at most 0.15 s away, or nullptr.
    const OwnPose* at(std::uint64_t capture_ns) const;
  };
  const std::vector<Player>& players() const { return players_; }

 private:
  std::vector<Player> players_;
};

}  // namespace robot::truth
