// The team's packets in the recording of one robot.
#pragma once

#include <cmath>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <string>
#include <vector>

#include "robot/fit/evidence.h"

namespace robot::fit {

/// A packet of a mate. Its times are by the clock of the record.
struct HeardPacket {
  unsigned mate = 0;        // jersey number of its sender
  double sent = NAN;        // [s] as the receiver dates it; NaN: not recorded
  double arrived = NAN;     // [s] NaN: not recorded
  double shown = 0;         // [s] capture time of the first `team` message with it
  double ball_age = NAN;    // [s] of the sender's ball when it sent, NaN without a ball
  double x = NAN, y = NAN;  // [m, team_field] where the sender believed to be; NaN: not sent
};

/// A packet of the robot itself.
struct SentPacket {
  double at = 0;             // [s] by the clock of the record
  std::uint32_t number = 0;  // messages_sent with it: 1, 2, 3 … without a missing one
};

/// The `team` messages of one robot's recording. Its clock is that of the truth, corrected by WatchedRobot::clock. Without a
/// truth it is the robot's own since the recording's start.
struct TeamRecord {
  std::string name;                      // of the recording
  std::string robot;                     // "14/2"
  std::shared_ptr<const TrueGame> game;  // absent without a truth: the clock cannot be compared with that of others
  double clock_deviation = 0;            // [s] one standard deviation
  std::vector<HeardPacket> heard;        // by arrival
  std::vector<SentPacket> sent;          // by time
  std::vector<double> written;           // [s] times of the messages, ascending
  bool simulated = false;                // received_ns is sent_ns: arrivals are those of the simulator's ticks
  double late = 0;                       // [s] median time from the arrival of a packet to the message with it
  std::size_t damaged = 0;               // packets with times that cannot be

  bool empty() const { return written.empty(); }
};

/// A simulated robot writes `team` at the end of the tick in which a packet arrives [s].
inline constexpr double kTick = 1 / 30.;

/// Reads the packets of a robot. A packet's arrival is `received_ns`. A simulated recording has none. There it is
/// a tick before the first message with the packet, unless the packet came within a pause of the recording.
TeamRecord read_team(const WatchedRobot& robot);
TeamRecord read_team(const UntrackedRobot& robot);

/// Returns those of all robots with a packet, those beside a truth first.
std::vector<TeamRecord> read_teams(const Evidence& evidence);

}  // namespace robot::fit
