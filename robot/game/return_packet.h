// What a robot answers to the GameController: that it is there, and since 2022 where it believes itself and the ball.
#pragma once

#include <cstdint>
#include <optional>
#include <string>

#include "proto/foresight/ball.pb.h"
#include "proto/foresight/motion.pb.h"
#include "proto/foresight/pose.pb.h"

namespace robot::game {

namespace pb = foresight;

/// Where the GameController takes answers, on the machine it runs on: GAMECONTROLLER_RETURN_PORT since 2016.
inline constexpr std::uint16_t kReturnPort = 3939;

/// Who answers, and what it knows; null where a memory object was never written.
struct RobotStatus {
  std::uint32_t team = 0, player = 0;
  const pb::MotionStatus* motion = nullptr;
  const pb::Pose* pose = nullptr;
  const pb::Ball* ball = nullptr;
  std::uint64_t now_ns = 0;  // [ns since the epoch]
};

/// The answer to a GameController that speaks format `version`: struct RoboCupGameControlReturnData of the same releases,
/// its version 2 (formats 9, 10), 3 (11 to 13) or 4 (14 to 18). Nothing for older ones: they took answers elsewhere.
///
/// Values that are not numbers are left at what says "not known": the GameController drops packets with such.
std::optional<std::string> return_packet(std::uint32_t version, const RobotStatus& status);

}  // namespace robot::game
