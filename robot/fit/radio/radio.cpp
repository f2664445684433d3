#include "robot/fit/radio/radio.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <utility>

#include "robot/core/text.h"
#include "robot/fit/math/resampling.h"
#include "robot/fit/radio/packet_ages.h"
#include "robot/fit/radio/packet_contents.h"
#include "robot/fit/radio/packets.h"
#include "robot/fit/radio/radio_evidence.h"
#include "robot/fit/radio/radio_model.h"
#include "sim/statistics/sample.h"

namespace robot::fit {
namespace {

constexpr std::size_t kFewestDelays = 50, kFewestFates = 50, kFewestGaps = 50;
constexpr double kNextInMeans = 3;                             // time to the next packet [mean delays]
constexpr double kWidestMeanDelay = 0.03, kWidestLoss = 0.05;  // [s], 1
constexpr double kWantedDelay = 0.01, kWantedLoss = 0.02;      // [s], 1
constexpr std::size_t kIntervalBlock = 50, kIntervalSamples = 200, kPacketFolds = 5;

std::vector<std::string> radio_recordings(const RadioEvidence& radio) {
  std::vector<std::string> names;
  for (const TeamRecord& record : radio.records) names.push_back(record.name);
  return names;
}

/// Returns one standard deviation of the mean delay by the errors of the clocks. A robot's error is in the delays that it
/// receives, and with the other sign in those that it sends.
double clock_part(const RadioEvidence& radio) {
  std::vector<double> weights(radio.records.size());
  for (const Delay& delay : radio.packets.delays) {
    if (delay.sender == kNoRecord) continue;
    weights[delay.receiver] += 1;
    weights[delay.sender] -= 1;
  }
  double sum = 0;
  for (std::size_t i = 0; i < weights.size(); ++i) sum = std::hypot(sum, radio.records[i].clock_deviation * weights[i]);
  return sum / static_cast<double>(radio.packets.delays.size());
}

Domain sending_domain(std::vector<double> intervals) {
  return {.quantity = "time between packets",
          .unit = "s",
          .from = sim::statistics::quantile(intervals, 0.025),
          .to = sim::statistics::quantile(intervals, 0.975)};
}

/// Returns the times between packets of each sender.
std::vector<std::vector<double>> intervals_of(const RadioEvidence& radio) {
  std::vector<std::vector<double>> all;
  for (const TeamRecord& record : radio.records) {
    std::vector<double> own;
    for (std::size_t i = 1; i < record.sent.size(); ++i)
      if (record.sent[i].number == record.sent[i - 1].number + 1)
        own.push_back(record.sent[i].at - record.sent[i - 1].at);
    if (!own.empty()) all.push_back(std::move(own));
  }
  return all.empty() ? radio.gaps.single : all;
}

std::vector<double> flattened(const std::vector<std::vector<double>>& parts) {
  std::vector<double> all;
  for (const std::vector<double>& part : parts) all.insert(all.end(), part.begin(), part.end());
  return all;
}

/// Blocks of neighbouring intervals share their luck.
std::vector<Group> interval_blocks(const std::vector<std::vector<double>>& parts) {
  std::vector<Group> blocks;
  std::size_t index = 0;
  for (const std::vector<double>& part : parts)
    for (std::size_t i = 0; i < part.size(); ++i, ++index) {
      if (i % kIntervalBlock == 0) blocks.emplace_back();
      blocks.back().push_back(index);
    }
  return blocks;
}

void fit_interval(const RadioEvidence& radio, Report& report) {
  const std::vector<std::vector<double>> parts = intervals_of(radio);
  const std::vector<double> all = flattened(parts);
  if (all.size() < kFewestGaps) {
    report.kept.push_back(
        formatted("radio.interval: expected at least %zu packets of robots that count their own, got %zu", kFewestGaps,
                  all.size()));
    return;
  }
  const std::vector<Group> blocks = interval_blocks(parts);
  const double value = sim::statistics::median(all);
  double half = 0;
  if (blocks.size() > 1) {
    const auto samples = resampled(blocks, kIntervalSamples, [&all](const std::vector<std::size_t>& chosen) -> Vector {
      std::vector<double> values;
      values.reserve(chosen.size());
      for (const std::size_t i : chosen) values.push_back(all[i]);
      return {lab::median_of(std::move(values))};
    });
    // times between whole ticks are known to half a tick
    half = std::hypot(two_sided(blocks.size() - 1) * deviations_of(samples)[0], radio.step / 2);
  }
  report.figures.push_back({.name = "radio.interval",
                            .unit = "s",
                            .value = value,
                            .low = value - half,
                            .high = value + half,
                            .events = all.size(),
                            .kind = "packets",
                            .recordings = radio_recordings(radio),
                            .domain = sending_domain(all)});
}

void keep_delay(const RadioEvidence& radio, std::size_t packets, Report& report) {
  if (packets > 0)
    report.kept.push_back(
        formatted("radio.delay: expected at least %zu packets with the times of sending and arrival, got %zu",
                  kFewestDelays, packets));
  else
    report.kept.push_back(formatted("radio.delay: expected the times of sending and arrival, got %s",
                                    radio.records.empty()
                                        ? "no recording with packets of the team"
                                        : "packets without a time of sending by a clock that is known"));
  report.needs.push_back(need_of("radio.delay", "packets", packets, kFewestDelays,
                                 "record `team` on two robots or more of one team, in a game with a truth"));
}

void fit_delays(const RadioEvidence& radio, Report& report) {
  const std::vector<std::vector<double>> delays = by_packet(radio.packets.delays);
  if (delays.size() < kFewestDelays) return keep_delay(radio, delays.size(), report);
  const Bounded mean = fit_delay(delays, radio.step, clock_part(radio));
  std::vector<double> intervals = flattened(intervals_of(radio));
  if (intervals.empty()) intervals = {0};
  report.figures.push_back({.name = "radio.delay",
                            .unit = "s",
                            .value = mean.value,
                            .low = mean.low,
                            .high = mean.high,
                            .events = delays.size(),
                            .kind = "packets",
                            .recordings = radio_recordings(radio),
                            .domain = sending_domain(std::move(intervals)),
                            .widest = kWidestMeanDelay});
  report.needs.push_back(
      need_of(report.figures.back(), kWantedDelay, "record longer, or compare the clocks of the robots more exactly"));
}

void add_loss(const std::string& name, const Bounded& loss, std::size_t events, const std::string& kind,
              std::vector<double> intervals, const RadioEvidence& radio, Report& report) {
  report.figures.push_back({.name = name,
                            .unit = "",
                            .value = loss.value,
                            .low = loss.low,
                            .high = loss.high,
                            .events = events,
                            .kind = kind,
                            .recordings = radio_recordings(radio),
                            .domain = sending_domain(std::move(intervals)),
                            .widest = kWidestLoss});
  report.needs.push_back(need_of(report.figures.back(), kWantedLoss, "record `team` on more robots of one team"));
}

void fit_gaps(const RadioEvidence& radio, Report& report) {
  const Gaps& gaps = radio.gaps;
  if (gaps.streams > 0) {
    std::vector<Shared> groups(gaps.expected, Shared{.sum = 0, .count = 1});
    for (std::size_t i = 0; i < gaps.missing; ++i) groups[i].sum = 1;
    report.notes.push_back("radio.loss_in_gaps is the loss at one listener, by gaps in regular packets");
    report.kept.push_back("radio.loss: expected the recordings of the senders, got gaps at one listener alone");
    return add_loss("radio.loss_in_gaps", fit_share(groups), gaps.expected, "regular packets", flattened(gaps.single),
                    radio, report);
  }
  const std::size_t packets = by_packet(radio.counted).size();
  if (gaps.irregular > 0)
    report.kept.push_back(
        formatted("radio.loss: expected the recordings of the senders, or packets at regular times, got gaps of %.2f "
                  "to %.2f s (10 to "
                  "90 %%)",
                  gaps.least, gaps.most));
  else
    report.kept.push_back(
        formatted("radio.loss: expected at least %zu packets in the recordings of their sender and of a mate, "
                  "got %zu",
                  kFewestFates, packets));
  report.needs.push_back(need_of("radio.loss", "packets", packets, kFewestFates,
                                 "record `team` on two robots or more of one team, in a game with a truth"));
}

void fit_losses(const RadioEvidence& radio, Report& report) {
  const std::vector<Shared> groups = by_packet(radio.counted);
  if (groups.size() < kFewestFates) return fit_gaps(radio, report);
  Bounded loss = fit_share(groups);
  loss.low = std::max(0., loss.low - radio.overtaken * (1 - loss.low));
  std::vector<double> intervals;
  for (const Fate& fate : radio.counted) intervals.push_back(fate.next);
  add_loss("radio.loss", loss, groups.size(), "packets", std::move(intervals), radio, report);
}

/// Chooses the packets that count for the loss, for a mean delay [s].
void choose_fates(double delay, RadioEvidence& radio) {
  double overtaken = 0;
  for (const Fate& fate : radio.packets.fates) {
    if (fate.next < kNextInMeans * delay) continue;
    radio.counted.push_back(fate);
    // a simulated robot has one packet on the air at most
    if (!radio.records[fate.receiver].simulated) overtaken += std::exp(-fate.next / delay) / 2;
  }
  if (!radio.counted.empty()) radio.overtaken = overtaken / static_cast<double>(radio.counted.size());
}

void note_radio(const RadioEvidence& radio, Report& report) {
  const auto add = [&report](std::size_t count, const char* what) {
    if (count > 0) report.notes.push_back(formatted("%zu %s", count, what));
  };
  std::size_t damaged = 0;
  for (const TeamRecord& record : radio.records) damaged += record.damaged;
  add(damaged, "packets left out: their times cannot be");
  add(radio.packets.unlisted, "packets left out: their sender's recording counts them but has no time of them");
  add(radio.packets.unwatched, "times a packet left out: its receiver's recording pauses, begins or ends around it");
  add(radio.packets.fates.size() - radio.counted.size(),
      "times a packet left out of the loss: the next one follows within three mean delays");
  add(radio.packets.late, "recordings left out of the loss: they write `team` more than 0.1 s after a packet");
  add(radio.packets.dated, "delays by the receiver's own clock offset, whose error is not known");
  if (radio.step > 0) report.notes.emplace_back("delays of simulated recordings are whole ticks of 1/30 s; corrected");
}

Table delay_table(const RadioEvidence& radio) {
  Table table{.columns = {"time of sending [s]", "delay [s]"}, .names = radio_recordings(radio), .rows = {}};
  for (const Delay& delay : radio.packets.delays)
    table.rows.push_back({.recording = delay.receiver, .values = {delay.at, delay.seconds}});
  return table;
}

Table fate_table(const RadioEvidence& radio) {
  Table table{.columns = {"time of sending [s]", "until the next packet [s]", "heard"},
              .names = radio_recordings(radio),
              .rows = {}};
  for (const Fate& fate : radio.counted)
    table.rows.push_back({.recording = fate.receiver, .values = {fate.at, fate.next, fate.heard ? 1. : 0.}});
  return table;
}

}  // namespace

Report fit_packets(std::vector<TeamRecord> records, const sim::perception::Radio& before) {
  Report report;
  report.name = "radio";
  report.title = "What the team's packets go through";
  RadioEvidence radio;
  radio.records = std::move(records);
  radio.packets = follow_packets(radio.records);
  radio.gaps = count_gaps(radio.records);
  const bool simulated = std::ranges::all_of(radio.records, &TeamRecord::simulated);
  radio.step = simulated && !radio.records.empty() ? kTick : 0;

  fit_delays(radio, report);
  const Figure* const delay = report.figure("radio.delay");
  choose_fates(delay ? delay->value : before.delay, radio);
  fit_losses(radio, report);
  fit_interval(radio, report);

  if (const Figure* const fitted = report.figure("radio.delay"))
    draw_delays(radio, fitted->value, before.delay, report);
  draw_ages(radio, before, report);
  judge_radio(radio, before, report);
  if (Results contents = results_of(summaries_of(radio.records)); !contents.rows.empty())
    report.results.push_back(std::move(contents));
  note_radio(radio, report);
  report.tables = {{"radio_delays", delay_table(radio)}, {"radio_losses", fate_table(radio)}};
  return report;
}

Report fit_radio(const Evidence& evidence, const sim::Models& base) {
  return fit_packets(read_teams(evidence), base.perception.radio);
}

}  // namespace robot::fit
