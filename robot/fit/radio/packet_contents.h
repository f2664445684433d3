// Contents and regularity of each sender's packets. They need no truth.
#pragma once

#include <string>
#include <vector>

#include "robot/fit/radio/team_record.h"
#include "robot/fit/report.h"

namespace robot::fit {

/// The packets of one sender, as the receiver that heard most of them has them.
struct SenderSummary {
  std::string sender;     // "14/2"
  std::string recording;  // of the receiver
  std::size_t packets = 0;
  double seconds = 0;         // [s] from the first to the last packet
  double gap = 0;             // [s] median between two packets
  double long_gap = 0;        // [s] 95 % of the gaps are shorter
  double longest_gap = 0;     // [s]
  double ball = 0;            // share of the packets with a ball seen within the last second
  double ball_age = NAN;      // [s] median over packets with a ball
  double old_ball_age = NAN;  // [s] 95 % are younger
  double speed = NAN;         // [m/s] median over a second, between poses without a jump
  double fast = NAN;          // [m/s] 95 % are slower
  std::size_t jumps = 0;      // of the pose: by more than 0.3 m and faster than 0.8 m/s between two packets
};

/// Summarises the packets of each sender with at least ten of them, in the order of the senders.
std::vector<SenderSummary> summaries_of(const std::vector<TeamRecord>& records);

/// Returns the summaries in rows, at most the first twelve.
Results results_of(const std::vector<SenderSummary>& summaries);

}  // namespace robot::fit
