// The scores of the radio on packets held out.
#include <algorithm>
#include <cmath>
#include <map>
#include <utility>

#include "robot/core/text.h"
#include "robot/fit/math/resampling.h"
#include "robot/fit/radio/packet_ages.h"
#include "robot/fit/radio/radio_evidence.h"
#include "sim/statistics/sample.h"

namespace robot::fit {

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

namespace {

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

}  // namespace

void judge_radio(const RadioEvidence& radio, const sim::perception::Radio& before, Report& report) {
  const PacketParts parts(radio);
  Results results{.title = "errors on packets held out: " + parts.text(),
                  .head = {"of", "packets", "fitted", "the models before", "a constant"},
                  .rows = {}};
  if (report.figure("radio.delay"))
    if (const DelayScores scores = score_delays(radio, parts, before.delay); scores.packets > 0) {
      const auto n = static_cast<double>(scores.packets);
      const auto milliseconds = [n](double sum) { return formatted("%.1f", 1000 * sum / n); };
      results.rows.push_back({"delay: CRPS [ms]", std::to_string(scores.packets), milliseconds(scores.fitted),
                              milliseconds(scores.before), milliseconds(scores.constant)});
      report.scores.emplace_back("delay_crps_s", scores.fitted / n);
    }
  if (report.figure("radio.loss"))
    if (const LossScores scores = score_losses(radio, parts, before.loss); scores.packets > 0) {
      const auto n = static_cast<double>(scores.packets);
      results.rows.push_back({"loss: log loss", std::to_string(scores.packets), formatted("%.4f", scores.fitted / n),
                              formatted("%.4f", scores.before / n), "-"});
      report.scores.emplace_back("loss_log_loss", scores.fitted / n);
    }
  if (!results.rows.empty()) report.results.push_back(std::move(results));
}

}  // namespace robot::fit
