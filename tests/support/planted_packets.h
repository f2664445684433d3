// Recordings of a team's packets with a known delay and loss.
#pragma once

#include <cstdint>
#include <vector>

#include "robot/fit/radio/team_record.h"

namespace robot::tests {

struct PlantedPackets {
  double delay = 0.15;  // [s] parameter of the exponential delay, cut at five of it
  double loss = 0.25;   // for each receiver
  double interval = 1;  // [s] between packets
  double jitter = 0.2;  // [s] more, evenly spread
  double minutes = 10;  // of the game
  unsigned robots = 5;
  double clock_error = 0;  // [s] one standard deviation of each robot's clock, which its record names
  bool ticks = false;      // a simulated game
  bool dated = true;       // receivers have a time of sending
};

/// Returns the records of a game. The same for the same seed.
std::vector<fit::TeamRecord> planted_packets(const PlantedPackets& planted, std::uint64_t seed);

}  // namespace robot::tests
