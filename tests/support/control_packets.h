// Packets of the GameController for tests, written value by value in the order of each year's RoboCupGameControlData.h.
// They do not use the tables that they test. Also reads captures of the real program.
#pragma once

#include <cstdint>
#include <filesystem>
#include <string>
#include <vector>

namespace tests {

struct ControlTeam {
  int number = 14, field_colour = 0, goalkeeper_colour = 1, goalkeeper = 1;
  int score = 0, penalty_shot = 0, single_shots = 0, message_budget = 1200;
  int penalised_player = 0;  // 0: nobody
  int penalty = 0, seconds_till_unpenalised = 0, warnings = 0, cautions = 0;
};

/// Values of a packet. Its format leaves out values without a place.
struct ControlPacketText {
  int packet_number = 0, players_per_team = 5;
  int state = 0, set_play = 0, phase = 0;
  int first_half = 1, stopped = 0;
  int kicking = 14;  // a colour in formats 7 and 8
  int seconds_remaining = 600, secondary_seconds = 0;
  ControlTeam first, second{.number = 5, .field_colour = 1, .goalkeeper_colour = 0};

  /// The packet in format 7 .. 20.
  std::string bytes(int version) const;
};

struct CapturedPacket {
  double seconds = 0;  // since the capture began
  std::string payload;
};

/// Returns all packets of a capture. Each is, in little endian, a double with the seconds, two bytes with the length, and the
/// payload. Returns an empty list if the file ends within a packet.
std::vector<CapturedPacket> read_capture(const std::filesystem::path& path);

}  // namespace tests
