// The packets in a log of the TeamCommunicationMonitor. teamcomm.h describes it.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace robot::lab::teamcomm {

/// One packet, with its numbers as they were sent.
struct Packet {
  std::uint64_t time_ms = 0;
  unsigned player = 0, team = 0;
  bool fallen = false;
  float x = 0, y = 0, heading = 0;  // [mm, mm; radians or degrees]
  float ball_age = 0;               // in the sender's unit
  float ball_x = 0, ball_y = 0;     // [mm]
};

struct Log {
  std::vector<Packet> packets;
  std::uint64_t repeated = 0;    // packets with the bytes of the last one of the same sender
  std::uint64_t unreadable = 0;  // of another version, or with numbers that are not finite
  std::string damage;            // one sentence: place and kind, or empty
};

/// Reads the packets of the log up to its first damage.
Log read_log(std::string_view file_bytes);

}  // namespace robot::lab::teamcomm
