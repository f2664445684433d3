// Packets of the GameController for tests: written value by value as each year's RoboCupGameControlData.h orders them,
// knowing nothing of the tables they test; and the captures of the real program.
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
  int penalty = 0, seconds_till_unpenalised = 0;
};

/// What a packet is to say; what its format has no place for is left out.
struct ControlPacketText {
  int packet_number = 0, players_per_team = 5;
  int state = 0, set_play = 0, phase = 0;
  int first_half = 1;
  int kicking = 14;  // a colour in formats 7 and 8
  int seconds_remaining = 600, secondary_seconds = 0;
  ControlTeam first, second{.number = 5, .field_colour = 1, .goalkeeper_colour = 0};

  /// The packet in format 7 .. 18.
  std::string bytes(int version) const;
};

struct CapturedPacket {
  double seconds = 0;  // since the capture began
  std::string payload;
};

/// All packets of a capture: little endian a double with the seconds, two bytes with the length, the payload.
/// Empty if the file does not end where a packet does.
std::vector<CapturedPacket> read_capture(const std::filesystem::path& path);

}  // namespace tests
