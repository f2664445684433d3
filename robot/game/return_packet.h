// The robot's answer to the GameController: a sign of life, and since 2022 its beliefs about its own pose and the ball.
#pragma once

#include <cstdint>
#include <optional>
#include <string>

#include "proto/foresight/ball.pb.h"
#include "proto/foresight/motion.pb.h"
#include "proto/foresight/pose.pb.h"

namespace robot::game {

namespace pb = foresight;

/// The port of the GameController's machine that receives answers: GAMECONTROLLER_RETURN_PORT since 2016.
inline constexpr std::uint16_t kReturnPort = 3939;

/// The robot that answers, and its beliefs; a pointer is null if that memory object was never written.
struct RobotStatus {
  std::uint32_t team = 0, player = 0;
  const pb::MotionStatus* motion = nullptr;
  const pb::Pose* pose = nullptr;
  const pb::Ball* ball = nullptr;
  std::uint64_t now_ns = 0;  // [ns since the epoch]
};

/// Returns the answer to a GameController of format `version`, or nothing for formats before 9, which used another
/// port, and for formats after 20, which are not known. It is struct RoboCupGameControlReturnData of the same releases:
/// version 2 (formats 9, 10), 3 (11 to 13) or 4 (14 to 20).
///
/// A value that is not a finite number is sent as "not known", because the GameController drops packets with such values.
std::optional<std::string> return_packet(std::uint32_t version, const RobotStatus& status);

}  // namespace robot::game
