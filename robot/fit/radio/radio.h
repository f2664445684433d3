// Delay and loss of the team's packets.
#pragma once

#include <vector>

#include "robot/fit/evidence.h"
#include "robot/fit/radio/team_record.h"
#include "robot/fit/report.h"
#include "sim/match/params.h"

namespace robot::fit {

/// Fits `radio.delay` [s] and `radio.loss` from `team`, and reports `radio.interval` [s], the median time between two packets
/// of a robot.
///
/// The delay is the mean of an exponential distribution that is cut at five means, as the simulator has it. Its sending and
/// its arrival are by the recordings of both robots in the same game; their clocks' errors add to the interval. Without the
/// sender's recording it is by the receiver's own clock offset. Delays of simulated recordings are whole ticks.
///
/// The loss is the share of a sender's packets that a mate does not hear, by the recordings of both. A packet counts only if
/// the next one follows at least three mean delays later, because `team` holds only the newest. The interval allows for
/// packets that the next one overtakes. Without any such pair, it is the share of gaps in regular packets.
///
/// All receivers of a packet share their luck. Not fitted with fewer than 50 packets, or without a sender's time.
Report fit_radio(const Evidence& evidence, const sim::Models& base);

/// Does the same for packets that were read. `before` is the radio of the models so far. Pure.
Report fit_packets(std::vector<TeamRecord> records, const sim::perception::Radio& before);

}  // namespace robot::fit
