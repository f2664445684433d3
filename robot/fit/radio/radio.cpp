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
#include "robot/fit/radio/radio_model.h"
#include "sim/statistics/sample.h"

namespace robot::fit {
namespace {

constexpr std::size_t kFewestDelays = 50, kFewestFates = 50, kFewestGaps = 50;
constexpr double kNextInMeans = 3;                             // time to the next packet [mean delays]
constexpr double kWidestMeanDelay = 0.03, kWidestLoss = 0.05;  // [s], 1
constexpr double kWantedDelay = 0.01, kWantedLoss = 0.02;      // [s], 1
constexpr std::size_t kIntervalBlock = 50, kIntervalSamples = 200, kPacketFolds = 5;

/// Everything that was read.
struct RadioEvidence {
  std::vector<TeamRecord> records;
  Packets packets;
  Gaps gaps;
  double step = 0;            // [s] of delays; 0: any
  std::vector<Fate> counted;  // those of packets that none overtakes, mostly
  double overtaken = 0;       // share of packets that the next one may overtake
};

std::vector<std::string> radio_recordings(const RadioEvidence& radio) {
  std::vector<std::string> names;
  for (const TeamRecord& record : radio.records) names.push_back(record.name);
  return names;
}

std::vector<std::vector<double>> by_packet(const std::vector<Delay>& delays) {
  std::map<std::size_t, std::vector<double>> groups;
  for (const Delay& delay : delays) groups[delay.packet].push_back(delay.seconds);
  std::vector<std::vector<double>> grouped;
  for (auto& [packet, values] : groups) grouped.push_back(std::move(values));
  return grouped;
}

std::vector<Shared> by_packet(const std::vector<Fate>& fates) {
  std::map<std::size_t, Shared> groups;
  for (const Fate& fate : fates) {
    Shared& group = groups[fate.packet];
    group.sum += fate.heard ? 0 : 1;
    ++group.count;
  }
  std::vector<Shared> grouped;
  for (const auto& [packet, group] : groups) grouped.push_back(group);
  return grouped;
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

void add_loss(const Bounded& loss, std::size_t events, const std::string& kind, std::vector<double> intervals,
              const RadioEvidence& radio, Report& report) {
  report.figures.push_back({.name = "radio.loss",
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
    report.notes.push_back("radio.loss is by gaps in regular packets: the recordings of their senders are missing");
    return add_loss(fit_share(groups), gaps.expected, "regular packets", flattened(gaps.single), radio, report);
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
  add_loss(loss, groups.size(), "packets", std::move(intervals), radio, report);
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

// --- pictures ---

/// Returns the chance of a delay from `from` to `to` [s].
double chance_between(double mean, double from, double to) {
  const auto later = [mean](double delay) {
    return delay > kLongestDelayInMeans * mean ? 0 : std::exp(-std::max(0., delay) / mean);
  };
  return later(from) - later(to);
}

Mark chances(const char* label, Mark::Role role, double mean, double width, double from, std::size_t bins) {
  Mark mark{.shape = Mark::Shape::line, .role = role, .label = label, .x = {}, .y = {}, .high = {}};
  for (std::size_t i = 0; i < bins; ++i) {
    const double left = from + width * static_cast<double>(i);
    if (left + width <= 0) continue;
    mark.x.push_back(left + width / 2);
    mark.y.push_back(100 * chance_between(mean, left, left + width));
  }
  return mark;
}

void draw_delays(const RadioEvidence& radio, double fitted, double before, Report& report) {
  const double width = radio.step > 0 ? radio.step : fitted / 4;
  constexpr std::size_t kBins = 26;
  const double from = radio.step > 0 ? -width / 2 : -4 * width;
  Mark bars{.shape = Mark::Shape::bars,
            .role = Mark::Role::truth,
            .label = "packets",
            .x = {},
            .y = {},
            .high = {},
            .width = width};
  for (std::size_t i = 0; i < kBins; ++i) bars.x.push_back(from + width * static_cast<double>(i));
  bars.y.resize(kBins);
  const double one = 100 / static_cast<double>(radio.packets.delays.size());
  for (const Delay& delay : radio.packets.delays)
    if (const double bin = std::floor((delay.seconds - from) / width); bin >= 0 && bin < kBins)
      bars.y[static_cast<std::size_t>(bin)] += one;
  double top = *std::ranges::max_element(bars.y);
  const Mark curve = chances("fitted", Mark::Role::fitted, fitted, width, from, kBins);
  const Mark other = chances("the models before", Mark::Role::other, before, width, from, kBins);
  for (const Mark* mark : {&curve, &other}) top = std::max(top, *std::ranges::max_element(mark->y));
  report.pictures.push_back({.title = "Delays of packets",
                             .x_label = "delay [s]",
                             .y_label = "packets [%]",
                             .axes = {.left = from, .right = from + width * kBins, .bottom = 0, .top = 1.1 * top},
                             .marks = {std::move(bars), other, curve}});
}

Mark age_line(const char* label, Mark::Role role, const AgeCurve& curve) {
  Mark mark{.shape = Mark::Shape::line, .role = role, .label = label, .x = curve.ages, .y = curve.shares, .high = {}};
  for (double& share : mark.y) share *= 100;
  return mark;
}

/// Returns the age that few packets reach [s]: the right edge of the picture.
double oldest_drawn(const AgeCurve& curve) {
  for (std::size_t i = 0; i < curve.ages.size(); ++i)
    if (curve.shares[i] < 0.01) return std::max(0.5, 1.2 * curve.ages[i]);
  return curve.ages.back();
}

const Figure* radio_figure(const Report& report, const std::string& name) {
  const auto found = std::ranges::find(report.figures, name, &Figure::name);
  return found == report.figures.end() ? nullptr : &*found;
}

void draw_ages(const RadioEvidence& radio, const sim::perception::Radio& before, Report& report) {
  const AgeCurve seen = observed_ages(radio.records);
  if (seen.ages.empty()) return;
  Picture picture{.title = "Age of a mate's newest packet",
                  .x_label = "age [s]",
                  .y_label = "time with an older one [%]",
                  .axes = {.left = 0, .right = oldest_drawn(seen), .bottom = 0, .top = 100},
                  .marks = {age_line("robots", Mark::Role::truth, seen)}};
  const Figure *delay = radio_figure(report, "radio.delay"), *loss = radio_figure(report, "radio.loss");
  if (const AgeCurve curve = expected_ages(radio.records, before.delay, before.loss); !curve.ages.empty())
    picture.marks.push_back(age_line("the models before", Mark::Role::other, curve));
  if (delay && loss)
    if (const AgeCurve curve = expected_ages(radio.records, delay->value, loss->value); !curve.ages.empty())
      picture.marks.push_back(age_line("fitted", Mark::Role::fitted, curve));
  report.pictures.push_back(std::move(picture));
}

// --- scores on packets held out ---

/// Splits packets by their receivers' games if there are several, else into fifths of the time.
class PacketParts {
 public:
  explicit PacketParts(const RadioEvidence& radio) : radio_(radio) {
    for (const TeamRecord& record : radio.records)
      if (std::ranges::find(games_, record.game.get()) == games_.end()) games_.push_back(record.game.get());
    for (const Delay& delay : radio.packets.delays)
      begin_ = std::min(begin_, delay.at), end_ = std::max(end_, delay.at);
  }

  std::size_t count() const { return games_.size() > 1 ? games_.size() : kPacketFolds; }
  std::string text() const {
    return games_.size() > 1 ? formatted("each of %zu games", games_.size()) : std::string("each fifth of the time");
  }

  std::size_t of(std::size_t receiver, double at) const {
    if (games_.size() > 1)
      return static_cast<std::size_t>(std::ranges::find(games_, radio_.records[receiver].game.get()) - games_.begin());
    const double share = (at - begin_) / std::max(1e-9, end_ - begin_);
    return static_cast<std::size_t>(std::clamp(share, 0., 0.999) * kPacketFolds);
  }

 private:
  const RadioEvidence& radio_;
  std::vector<const TrueGame*> games_;
  double begin_ = INFINITY, end_ = -INFINITY;
};

/// Scores of delays [s]: of the fitted distribution, of the models before and of a constant.
struct DelayScores {
  double fitted = 0, before = 0, constant = 0;
  std::size_t packets = 0;
};

DelayScores score_delays(const RadioEvidence& radio, const PacketParts& parts, double before) {
  DelayScores scores;
  for (std::size_t part = 0; part < parts.count(); ++part) {
    std::vector<Delay> others;
    for (const Delay& delay : radio.packets.delays)
      if (parts.of(delay.receiver, delay.at) != part) others.push_back(delay);
    const std::vector<std::vector<double>> grouped = by_packet(others);
    if (grouped.size() < kFewestDelays / 2) continue;
    const double mean = fit_delay(grouped, radio.step, 0).value, middle = lab::median_of(flattened(grouped));
    for (const Delay& delay : radio.packets.delays) {
      if (parts.of(delay.receiver, delay.at) != part) continue;
      scores.fitted += delay_score(mean, delay.seconds);
      scores.before += delay_score(before, delay.seconds);
      scores.constant += std::abs(delay.seconds - middle);
      ++scores.packets;
    }
  }
  return scores;
}

/// Log loss of fates: by the fitted loss and by the models before.
struct LossScores {
  double fitted = 0, before = 0;
  std::size_t packets = 0;
};

LossScores score_losses(const RadioEvidence& radio, const PacketParts& parts, double before) {
  const auto log_loss = [](double loss, bool heard) {
    const double chance = std::clamp(loss, 1e-3, 1 - 1e-3);
    return -std::log(heard ? 1 - chance : chance);
  };
  std::vector<double> lost(parts.count()), all(parts.count());
  double total_lost = 0, total = 0;
  for (const Fate& fate : radio.counted) {
    const std::size_t part = parts.of(fate.receiver, fate.at);
    lost[part] += fate.heard ? 0 : 1, all[part] += 1;
    total_lost += fate.heard ? 0 : 1, total += 1;
  }
  LossScores scores;
  for (const Fate& fate : radio.counted) {
    const std::size_t part = parts.of(fate.receiver, fate.at);
    if (total - all[part] < 1) continue;
    scores.fitted += log_loss((total_lost - lost[part]) / (total - all[part]), fate.heard);
    scores.before += log_loss(before, fate.heard);
    ++scores.packets;
  }
  return scores;
}

void judge_radio(const RadioEvidence& radio, const sim::perception::Radio& before, Report& report) {
  const PacketParts parts(radio);
  Results results{.title = "errors on packets held out: " + parts.text(),
                  .head = {"of", "packets", "fitted", "the models before", "a constant"},
                  .rows = {}};
  if (radio_figure(report, "radio.delay"))
    if (const DelayScores scores = score_delays(radio, parts, before.delay); scores.packets > 0) {
      const auto n = static_cast<double>(scores.packets);
      const auto milliseconds = [n](double sum) { return formatted("%.1f", 1000 * sum / n); };
      results.rows.push_back({"delay: CRPS [ms]", std::to_string(scores.packets), milliseconds(scores.fitted),
                              milliseconds(scores.before), milliseconds(scores.constant)});
      report.scores.emplace_back("delay_crps_s", scores.fitted / n);
    }
  if (radio_figure(report, "radio.loss"))
    if (const LossScores scores = score_losses(radio, parts, before.loss); scores.packets > 0) {
      const auto n = static_cast<double>(scores.packets);
      results.rows.push_back({"loss: log loss", std::to_string(scores.packets), formatted("%.4f", scores.fitted / n),
                              formatted("%.4f", scores.before / n), "-"});
      report.scores.emplace_back("loss_log_loss", scores.fitted / n);
    }
  if (!results.rows.empty()) report.results.push_back(std::move(results));
}

// --- notes and tables ---

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
  const Figure* const delay = radio_figure(report, "radio.delay");
  choose_fates(delay ? delay->value : before.delay, radio);
  fit_losses(radio, report);
  fit_interval(radio, report);

  if (const Figure* const fitted = radio_figure(report, "radio.delay"))
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
