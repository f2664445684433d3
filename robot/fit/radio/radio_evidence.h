// The packets behind fit_radio(), with the parts of its report that only show and judge. Internal to robot/fit/radio.
#pragma once

#include <string>
#include <vector>

#include "robot/fit/radio/packets.h"
#include "robot/fit/radio/radio_model.h"
#include "robot/fit/radio/team_record.h"
#include "robot/fit/report.h"
#include "sim/perception/model.h"

namespace robot::fit {

/// Everything that was read.
struct RadioEvidence {
  std::vector<TeamRecord> records;
  Packets packets;
  Gaps gaps;
  double step = 0;            // [s] of delays; 0: any
  std::vector<Fate> counted;  // those of packets that none overtakes, mostly
  double overtaken = 0;       // share of packets that the next one may overtake
};

/// Returns the delays, or the losses, of each packet together: its receivers share their luck.
std::vector<std::vector<double>> by_packet(const std::vector<Delay>& delays);
std::vector<Shared> by_packet(const std::vector<Fate>& fates);

/// Adds the pictures of delays and of ages, beside the models `before`.
void draw_delays(const RadioEvidence& radio, double fitted, double before, Report& report);
void draw_ages(const RadioEvidence& radio, const sim::perception::Radio& before, Report& report);

/// Adds scores of delays and losses on packets held out.
void judge_radio(const RadioEvidence& radio, const sim::perception::Radio& before, Report& report);

}  // namespace robot::fit
