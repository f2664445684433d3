#include "robot/fit/radio/packets.h"

#include <algorithm>
#include <cstdlib>
#include <optional>
#include <string>
#include <utility>

#include "robot/lab/clocks/series.h"

namespace robot::fit {
namespace {

constexpr double kLongestWay = 2;        // [s] from sender to receiver
constexpr double kLongestSilence = 2.5;  // [s] between two messages of a receiver
constexpr double kPrompt = 0.1;          // [s] after an arrival
constexpr double kMostDateError = 0.25;  // [s] of a packet's time by its receiver
constexpr std::size_t kFewestPackets = 50;
constexpr double kNearMultiple = 0.25, kLeastRegular = 0.9, kMostMultiples = 5;

/// Returns the jersey number of "14/2".
unsigned number_of(const std::string& robot) {
  const std::size_t slash = robot.find('/');
  return slash == std::string::npos ? 0 : static_cast<unsigned>(std::strtoul(robot.c_str() + slash + 1, nullptr, 10));
}

/// Reports whether the packets of one robot, by its own recording, are meant for another one.
bool are_mates(const TeamRecord& sender, const TeamRecord& receiver) {
  const auto team = [](const TeamRecord& record) { return record.robot.substr(0, record.robot.find('/')); };
  return sender.game && sender.game == receiver.game && !sender.sent.empty() && sender.robot != receiver.robot &&
         team(sender) == team(receiver);
}

/// Returns the packets of one mate.
std::vector<HeardPacket> heard_from(const TeamRecord& receiver, unsigned mate) {
  std::vector<HeardPacket> packets;
  for (const HeardPacket& packet : receiver.heard)
    if (packet.mate == mate) packets.push_back(packet);
  return packets;
}

/// Returns the index of the sent packet that was heard, or nothing if none fits: the nearest by the time of sending, else the
/// last before the arrival.
std::optional<std::size_t> sent_index(const std::vector<SentPacket>& sent, const HeardPacket& heard,
                                      double clock_error) {
  if (!std::isnan(heard.sent)) {
    const auto after = std::ranges::lower_bound(sent, heard.sent, {}, &SentPacket::at);
    auto nearest = after;
    if (after == sent.end() || (after != sent.begin() && heard.sent - (after - 1)->at < after->at - heard.sent))
      nearest = after == sent.begin() ? sent.end() : after - 1;
    if (nearest == sent.end() || std::abs(nearest->at - heard.sent) > kMostDateError) return std::nullopt;
    return static_cast<std::size_t>(nearest - sent.begin());
  }
  if (std::isnan(heard.arrived)) return std::nullopt;
  const auto after = std::ranges::upper_bound(sent, heard.arrived + 2 * clock_error, {}, &SentPacket::at);
  if (after == sent.begin() || heard.arrived - (after - 1)->at > kLongestWay) return std::nullopt;
  return static_cast<std::size_t>(after - 1 - sent.begin());
}

/// Reports whether the receiver wrote messages before a moment and all the time in which the packet may come.
bool watches(const TeamRecord& receiver, double at) {
  const auto& written = receiver.written;
  auto next = std::ranges::upper_bound(written, at);
  if (next == written.begin()) return false;
  for (double last = *(next - 1); next != written.end(); last = *next++) {
    if (*next - last > kLongestSilence) return false;
    if (*next > at + kLongestWay) return true;
  }
  return false;
}

/// A pair of recordings and the number of the sender's first packet.
struct Way {
  const std::vector<TeamRecord>& records;
  std::size_t sender, receiver, first;
};

void follow(const Way& way, const std::vector<HeardPacket>& heard, Packets& packets) {
  const TeamRecord &sender = way.records[way.sender], &receiver = way.records[way.receiver];
  const std::vector<SentPacket>& sent = sender.sent;
  const double error = std::hypot(sender.clock_deviation, receiver.clock_deviation);
  std::vector<bool> came(sent.size());
  for (const HeardPacket& packet : heard) {
    const auto index = sent_index(sent, packet, error);
    if (!index || came[*index]) continue;
    came[*index] = true;
    const double seconds = packet.arrived - sent[*index].at;
    if (std::abs(seconds) < kLongestWay)  // no delay if the arrival is not known
      packets.delays.push_back({.packet = way.first + *index,
                                .sender = way.sender,
                                .receiver = way.receiver,
                                .at = sent[*index].at,
                                .seconds = seconds});
  }
  if (receiver.late > kPrompt) return;
  for (std::size_t i = 0; i + 1 < sent.size(); ++i) {
    if (sent[i + 1].number != sent[i].number + 1) continue;  // the time of the next packet is not known
    if (!watches(receiver, sent[i].at)) {
      ++packets.unwatched;
      continue;
    }
    packets.fates.push_back({.packet = way.first + i,
                             .sender = way.sender,
                             .receiver = way.receiver,
                             .at = sent[i].at,
                             .next = sent[i + 1].at - sent[i].at,
                             .heard = came[i]});
  }
}

/// Adds the delays that a receiver's own clock offsets give.
void add_dated(std::size_t receiver, const std::vector<HeardPacket>& heard, std::size_t& next, Packets& packets) {
  for (const HeardPacket& packet : heard) {
    const double seconds = packet.arrived - packet.sent;
    if (!(std::abs(seconds) < kLongestWay)) continue;
    packets.delays.push_back({.packet = next++, .receiver = receiver, .at = packet.sent, .seconds = seconds});
    ++packets.dated;
  }
}

/// Returns how many packets the sender's counter has more than its recording shows.
std::size_t unlisted_in(const std::vector<SentPacket>& sent) {
  std::size_t count = 0;
  for (std::size_t i = 1; i < sent.size(); ++i)
    if (sent[i].number > sent[i - 1].number) count += sent[i].number - sent[i - 1].number - 1;
  return count;
}

std::vector<unsigned> mates_of(const TeamRecord& record) {
  std::vector<unsigned> mates;
  for (const HeardPacket& packet : record.heard)
    if (std::ranges::find(mates, packet.mate) == mates.end()) mates.push_back(packet.mate);
  std::ranges::sort(mates);
  return mates;
}

/// Returns the interval whose multiples the gaps may be: the median of those like the shortest quarter.
double interval_of(const std::vector<double>& gaps) {
  std::vector<double> ordered = gaps;
  std::ranges::sort(ordered);
  const double short_one = ordered[ordered.size() / 4];
  std::vector<double> single;
  for (const double gap : ordered)
    if (gap > 0.5 * short_one && gap < 1.5 * short_one) single.push_back(gap);
  return lab::median_of(std::move(single));
}

void count_stream(std::vector<double> gaps, Gaps& all) {
  const double interval = interval_of(gaps);
  std::size_t near = 0, expected = 0, count = 0;
  std::vector<double> single;
  for (const double gap : gaps) {
    const double times = gap / interval, whole = std::round(times);
    if (whole > kMostMultiples) continue;
    ++count;
    if (whole <= 1) single.push_back(gap);
    near += whole >= 1 && std::abs(times - whole) <= kNearMultiple;
    expected += static_cast<std::size_t>(std::max(1., whole));
  }
  if (static_cast<double>(near) < kLeastRegular * static_cast<double>(count)) {
    std::ranges::sort(gaps);
    ++all.irregular;
    all.least = gaps[gaps.size() / 10], all.most = gaps[gaps.size() * 9 / 10];
    return;
  }
  ++all.streams;
  all.expected += expected;
  all.missing += expected - count;
  all.single.push_back(std::move(single));
}

}  // namespace

std::size_t sender_of(const std::vector<TeamRecord>& records, const TeamRecord& receiver, unsigned mate) {
  for (std::size_t i = 0; i < records.size(); ++i)
    if (are_mates(records[i], receiver) && number_of(records[i].robot) == mate) return i;
  return kNoRecord;
}

Packets follow_packets(const std::vector<TeamRecord>& records) {
  Packets packets;
  std::vector<std::size_t> first;
  std::size_t next = 0;
  for (const TeamRecord& record : records) {
    first.push_back(next);
    next += record.sent.size();
    packets.unlisted += unlisted_in(record.sent);
    packets.late += record.late > kPrompt;
  }
  for (std::size_t receiver = 0; receiver < records.size(); ++receiver) {
    const TeamRecord& record = records[receiver];
    if (record.heard.empty()) continue;  // a program that keeps no packets of others
    for (std::size_t sender = 0; sender < records.size(); ++sender)
      if (are_mates(records[sender], record))
        follow({.records = records, .sender = sender, .receiver = receiver, .first = first[sender]},
               heard_from(record, number_of(records[sender].robot)), packets);
    for (const unsigned mate : mates_of(record))
      if (sender_of(records, record, mate) == kNoRecord) add_dated(receiver, heard_from(record, mate), next, packets);
  }
  return packets;
}

Gaps count_gaps(const std::vector<TeamRecord>& records) {
  Gaps all;
  for (const TeamRecord& record : records) {
    if (record.late > kPrompt) continue;
    for (const unsigned mate : mates_of(record)) {
      if (sender_of(records, record, mate) != kNoRecord) continue;
      const std::vector<HeardPacket> heard = heard_from(record, mate);
      std::vector<double> gaps;
      for (std::size_t i = 1; i < heard.size(); ++i) {
        const bool dated = !std::isnan(heard[i].sent) && !std::isnan(heard[i - 1].sent);
        const double gap = dated ? heard[i].sent - heard[i - 1].sent : heard[i].arrived - heard[i - 1].arrived;
        if (gap > 0) gaps.push_back(gap);
      }
      if (gaps.size() >= kFewestPackets) count_stream(std::move(gaps), all);
    }
  }
  return all;
}

}  // namespace robot::fit
