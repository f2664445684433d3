#include <algorithm>
#include <cmath>
#include <map>
#include <random>
#include <utility>

#include "robot/core/text.h"
#include "robot/fit/checking/checks.h"
#include "robot/fit/radio/radio_model.h"

namespace robot::fit {
namespace {

constexpr std::size_t kFewestCheckedPackets = 50;
constexpr double kNextPacket = 3;          // [mean delays] until the sender's next packet, as in the fit of the radio
constexpr double kLeastCappedDelay = 0.5;  // [s] longer delays count as so long, or as five means

/// Returns the observations in groups of one packet.
std::vector<Shared> grouped(const std::vector<std::pair<std::size_t, double>>& values) {
  std::map<std::size_t, Shared> groups;
  for (const auto& [packet, value] : values) {
    groups[packet].sum += value;
    ++groups[packet].count;
  }
  std::vector<Shared> all;
  for (const auto& [packet, group] : groups) all.push_back(group);
  return all;
}

/// The mean of all observations, and the deviation that the luck of whole packets gives it.
struct PacketMean {
  double mean = 0, deviation = 0, count = 0;
};

PacketMean mean_over(const std::vector<Shared>& groups) {
  PacketMean mean;
  for (const Shared& group : groups) mean.mean += group.sum, mean.count += static_cast<double>(group.count);
  mean.mean /= mean.count;
  for (const Shared& group : groups)
    mean.deviation = std::hypot(mean.deviation, group.sum - mean.mean * static_cast<double>(group.count));
  mean.deviation /= mean.count;
  return mean;
}

/// Returns one standard deviation of the mean delay by the clocks' errors, which senders and receivers share.
double deviation_by_clocks(const std::vector<TeamRecord>& records, const std::vector<Delay>& delays) {
  std::vector<double> weights(records.size());
  for (const Delay& delay : delays) {
    if (delay.sender == kNoRecord) continue;
    weights[delay.receiver] += 1, weights[delay.sender] -= 1;
  }
  double deviation = 0;
  for (std::size_t i = 0; i < weights.size(); ++i)
    deviation = std::hypot(deviation, records[i].clock_deviation * weights[i]);
  return deviation / static_cast<double>(delays.size());
}

Statistic check_delay(const std::vector<TeamRecord>& records, const std::vector<Delay>& delays, double model) {
  const bool ticks = std::ranges::all_of(records, &TeamRecord::simulated);
  const double most = std::max(kLeastCappedDelay, kLongestDelayInMeans * model + kTick);
  std::vector<std::pair<std::size_t, double>> values;
  for (const Delay& delay : delays) values.emplace_back(delay.packet, std::min(delay.seconds, most));
  const std::vector<Shared> groups = grouped(values);
  const PacketMean recorded = mean_over(groups);
  // all receivers of a packet have one exponential delay
  double packets = 0;
  for (const Shared& group : groups) packets = std::hypot(packets, static_cast<double>(group.count));
  const double luck = model * packets / recorded.count;
  Statistic statistic{.name = "radio: mean delay",
                      .unit = "s",
                      .recorded = recorded.mean,
                      .simulated = {},
                      .events = groups.size(),
                      .kind = "packets"};
  std::mt19937_64 random(7);
  std::normal_distribution<double> drawn(
      mean_delay(model, ticks ? kTick : 0),
      std::hypot(std::max({luck, recorded.deviation, 1e-4}), deviation_by_clocks(records, delays)));
  for (std::size_t i = 0; i < kCheckSamples; ++i) statistic.simulated.push_back(drawn(random));
  return statistic;
}

Statistic check_loss(const std::vector<Shared>& groups, double overtaken, double loss) {
  const PacketMean recorded = mean_over(groups);
  // where receivers share their losses more than by chance, the packets are worth fewer
  const double by_chance = std::sqrt(recorded.mean * (1 - recorded.mean) / recorded.count);
  const double worse = by_chance > 0 ? std::max(1., recorded.deviation / by_chance) : 1;
  const auto worth = static_cast<int>(std::lround(std::max(1., recorded.count / (worse * worse))));
  Statistic statistic{.name = "radio: share of lost packets",
                      .unit = "",
                      .recorded = recorded.mean,
                      .simulated = {},
                      .events = groups.size(),
                      .kind = "packets"};
  std::mt19937_64 random(8);
  std::uniform_real_distribution<double> uniform(0, overtaken);
  std::binomial_distribution<int> lost(worth, loss);
  for (std::size_t i = 0; i < kCheckSamples; ++i) {
    const double share = static_cast<double>(lost(random)) / worth;
    statistic.simulated.push_back(share + (1 - share) * uniform(random));
  }
  return statistic;
}

}  // namespace

std::vector<Statistic> check_packets(const std::vector<TeamRecord>& records, const sim::Models& models,
                                     std::vector<std::string>& missing) {
  const Packets packets = follow_packets(records);
  const double delay = models.effects.packet_delay ? models.perception.radio.delay : 0;
  const double loss = models.effects.packet_loss ? models.perception.radio.loss : 0;
  std::vector<Statistic> all;
  if (packets.delays.size() >= kFewestCheckedPackets)
    all.push_back(check_delay(records, packets.delays, delay));
  else
    missing.push_back(formatted("radio: expected at least %zu packets with the times of sending and arrival, got %zu",
                                kFewestCheckedPackets, packets.delays.size()));
  std::vector<std::pair<std::size_t, double>> fates;
  double overtaken = 0;
  for (const Fate& fate : packets.fates) {
    if (fate.next < kNextPacket * delay) continue;
    fates.emplace_back(fate.packet, fate.heard ? 0 : 1);
    if (!records[fate.receiver].simulated && delay > 0) overtaken += std::exp(-fate.next / delay) / 2;
  }
  if (fates.size() >= kFewestCheckedPackets)
    all.push_back(check_loss(grouped(fates), overtaken / static_cast<double>(fates.size()), loss));
  else
    missing.push_back(
        formatted("radio: expected at least %zu packets in the recordings of their sender and of a mate, got %zu",
                  kFewestCheckedPackets, fates.size()));
  return all;
}

}  // namespace robot::fit
