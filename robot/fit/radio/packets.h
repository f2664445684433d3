// The fates of a team's packets: who heard them, and when.
#pragma once

#include <cmath>
#include <cstddef>
#include <limits>
#include <vector>

#include "robot/fit/radio/team_record.h"

namespace robot::fit {

/// Index of a record that is not there.
inline constexpr std::size_t kNoRecord = std::numeric_limits<std::size_t>::max();

/// The time that a packet took to one receiver.
struct Delay {
  std::size_t packet = 0;                        // the same for all receivers of one packet
  std::size_t sender = kNoRecord, receiver = 0;  // records
  double at = 0;                                 // [s] of sending
  double seconds = 0;                            // below 0 by an error of the clocks
};

/// A packet that one receiver heard or did not.
struct Fate {
  std::size_t packet = 0;
  std::size_t sender = 0, receiver = 0;  // records
  double at = 0;                         // [s] of sending
  double next = 0;                       // [s] until the sender's next packet
  bool heard = false;
};

struct Packets {
  std::vector<Delay> delays;
  std::vector<Fate> fates;
  std::size_t unlisted = 0;   // packets that their sender's own recording counts but does not show
  std::size_t unwatched = 0;  // pairs of packet and receiver whose recording pauses, begins or ends around it
  std::size_t late = 0;       // receivers that write `team` too late to count losses
  std::size_t dated = 0;      // delays by the receiver's own clock offset, because the sender has no recording
};

/// Follows each packet from the recording of its sender to those of its mates in the same game. Clocks are those of the truth.
///
/// `team` holds only the newest packet of a mate. A receiver that writes it more than 0.1 s after an arrival may miss packets,
/// so it counts for no fate. A packet counts only if the receiver wrote messages before it and around the 2 s after it.
/// Packets whose sender has no recording have a delay if the receiver dated them, but no fate.
Packets follow_packets(const std::vector<TeamRecord>& records);

/// Losses as gaps in the packets of senders that have no recording.
struct Gaps {
  std::size_t streams = 0;                  // of one sender to one receiver, regular
  std::vector<std::vector<double>> single;  // [s] of each of them, without those over a missing packet
  std::size_t expected = 0;                 // packets of regular streams
  std::size_t missing = 0;                  // of them
  std::size_t irregular = 0;                // streams whose gaps are no multiples of an interval
  double least = NAN, most = NAN;           // [s] 10 % and 90 % of the gaps of the last irregular stream
};

/// Counts missing packets in streams whose gaps are multiples of one interval: at least 50 packets, 90 % of the gaps within
/// a quarter of the interval of a multiple. Gaps of more than five intervals are pauses of the sender.
Gaps count_gaps(const std::vector<TeamRecord>& records);

/// Returns the index of the recording of a receiver's mate in the same game, or kNoRecord without one.
std::size_t sender_of(const std::vector<TeamRecord>& records, const TeamRecord& receiver, unsigned mate);

}  // namespace robot::fit
