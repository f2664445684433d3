#include "robot/fit/radio/packet_contents.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <utility>

#include "robot/core/text.h"
#include "sim/statistics/sample.h"

namespace robot::fit {
namespace {

constexpr std::size_t kFewestHeardPackets = 10, kMostSenders = 12;
constexpr double kFreshBall = 1;                            // [s]
constexpr double kPoseJump = 0.3, kPoseJumpSpeed = 0.8;     // [m], [m/s]
constexpr double kPoseSpeedTime = 1, kLongestPoseStep = 2;  // [s]

double packet_time(const HeardPacket& packet) { return std::isnan(packet.sent) ? packet.arrived : packet.sent; }

void measure_gaps(const std::vector<HeardPacket>& packets, SenderSummary& summary) {
  std::vector<double> gaps;
  for (std::size_t i = 1; i < packets.size(); ++i)
    gaps.push_back(packet_time(packets[i]) - packet_time(packets[i - 1]));
  summary.seconds = packet_time(packets.back()) - packet_time(packets.front());
  summary.gap = sim::statistics::median(gaps);
  summary.long_gap = sim::statistics::quantile(gaps, 0.95);
  summary.longest_gap = *std::ranges::max_element(gaps);
}

void measure_ball(const std::vector<HeardPacket>& packets, SenderSummary& summary) {
  std::vector<double> ages;
  std::size_t fresh = 0;
  for (const HeardPacket& packet : packets) {
    if (std::isnan(packet.ball_age)) continue;
    ages.push_back(packet.ball_age);
    fresh += packet.ball_age <= kFreshBall;
  }
  summary.ball = static_cast<double>(fresh) / static_cast<double>(packets.size());
  summary.ball_age = sim::statistics::median(ages);
  summary.old_ball_age = sim::statistics::quantile(ages, 0.95);
}

bool is_jump(const HeardPacket& before, const HeardPacket& after) {
  const double way = std::hypot(after.x - before.x, after.y - before.y);
  return way > kPoseJump && way > kPoseJumpSpeed * (packet_time(after) - packet_time(before));
}

/// Measures speeds over a second each, between jumps of the pose.
void measure_speed(const std::vector<HeardPacket>& packets, SenderSummary& summary) {
  std::vector<double> speeds;
  std::size_t start = 0;
  for (std::size_t i = 1; i < packets.size(); ++i) {
    const HeardPacket &first = packets[start], &here = packets[i];
    const bool jump = is_jump(packets[i - 1], here);
    summary.jumps += jump;
    const double time = packet_time(here) - packet_time(first);
    if (jump || std::isnan(here.x) || packet_time(here) - packet_time(packets[i - 1]) > kLongestPoseStep) {
      start = i;
    } else if (time >= kPoseSpeedTime) {
      speeds.push_back(std::hypot(here.x - first.x, here.y - first.y) / time);
      start = i;
    }
  }
  std::erase_if(speeds, [](double speed) { return std::isnan(speed); });
  summary.speed = sim::statistics::median(speeds);
  summary.fast = sim::statistics::quantile(speeds, 0.95);
}

std::string percent(double value) { return formatted("%.0f %%", 100 * value); }
std::string decimals(double value) { return std::isnan(value) ? "-" : formatted("%.2f", value); }

}  // namespace

std::vector<SenderSummary> summaries_of(const std::vector<TeamRecord>& records) {
  struct Best {
    std::vector<HeardPacket> packets;
    const TeamRecord* record = nullptr;
  };
  std::map<std::pair<const TrueGame*, std::string>, Best> best;
  for (const TeamRecord& record : records) {
    std::map<unsigned, std::vector<HeardPacket>> by_mate;
    for (const HeardPacket& packet : record.heard)
      if (!std::isnan(packet_time(packet))) by_mate[packet.mate].push_back(packet);
    for (auto& [mate, packets] : by_mate) {
      const std::string sender = record.robot.substr(0, record.robot.find('/') + 1) + std::to_string(mate);
      Best& known = best[{record.game.get(), sender}];
      if (packets.size() > known.packets.size()) known = {.packets = std::move(packets), .record = &record};
    }
  }
  std::vector<SenderSummary> summaries;
  for (const auto& [key, sender] : best) {
    if (sender.packets.size() < kFewestHeardPackets) continue;
    SenderSummary summary{.sender = key.second, .recording = sender.record->name, .packets = sender.packets.size()};
    measure_gaps(sender.packets, summary);
    measure_ball(sender.packets, summary);
    measure_speed(sender.packets, summary);
    summaries.push_back(std::move(summary));
  }
  std::ranges::stable_sort(summaries, {}, &SenderSummary::sender);
  return summaries;
}

Results results_of(const std::vector<SenderSummary>& summaries) {
  Results results{.title = "packets of each sender, as the mate that heard most of them has them",
                  .head = {"sender", "packets", "time [s]", "per second", "gap [s]", "95 % [s]", "longest [s]",
                           "ball seen", "ball age [s]", "95 % [s]", "speed [m/s]", "95 % [m/s]", "pose jumps"},
                  .rows = {}};
  for (const SenderSummary& one : summaries) {
    if (results.rows.size() == kMostSenders) break;
    results.rows.push_back({one.sender, std::to_string(one.packets), formatted("%.1f", one.seconds),
                            decimals(static_cast<double>(one.packets - 1) / one.seconds), decimals(one.gap),
                            decimals(one.long_gap), decimals(one.longest_gap), percent(one.ball),
                            decimals(one.ball_age), decimals(one.old_ball_age), decimals(one.speed), decimals(one.fast),
                            std::to_string(one.jumps)});
  }
  return results;
}

}  // namespace robot::fit
