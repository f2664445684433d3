// One packet of SSL-Vision, checked, in metres and with our numbers of teams and players.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "robot/core/result.h"

namespace robot::truth {

/// The teams by the colour of their robots.
struct SslTeams {
  std::uint32_t yellow = 14, blue = 5;  // team numbers
};

/// A camera has a number below this.
inline constexpr std::uint32_t kMaxSslCameras = 64;

/// A ball in one image [m, field].
struct SslBall {
  double x = 0, y = 0;
  double confidence = 0;  // [0..1]
};

/// A robot in one image [m, field].
struct SslRobot {
  std::uint32_t team = 0;
  std::optional<std::uint32_t> player = {};  // absent: not recognised, or no player's number
  double x = 0, y = 0;
  std::optional<double> heading = {};  // [rad] (-π, π]
  double confidence = 0;               // [0..1]
};

/// The view of one camera at one moment.
struct SslView {
  std::uint32_t camera = 0, frame = 0;
  double sent = 0;               // [s, their clock]
  std::uint64_t latency_ns = 0;  // from the image to the packet
  std::vector<SslBall> balls = {};
  std::vector<SslRobot> robots = {};
};

/// The size of the field [m].
struct SslField {
  double length = 0, width = 0;
  double border = 0;  // from a line to the wall
};

/// The content of one packet.
struct SslPacket {
  std::optional<SslView> view;
  std::optional<SslField> field;  // absent also if it is not of today's format
  std::string warning;            // a sentence about a robot whose id is no player's number, or empty
};

/// Reads a packet. A robot's id is the number of the player. A robot with an id outside 1 .. 20 has no player, and the
/// packet has a warning.
/// Returns an Error that names the field if the bytes are no packet of SSL-Vision, or for a place beyond 50 m, a latency
/// outside 0 .. 10 s, a number that is not finite, or more than 64 balls or robots of a team.
Result<SslPacket> read_ssl_packet(std::string_view bytes, const SslTeams& teams);

}  // namespace robot::truth
