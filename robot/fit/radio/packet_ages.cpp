#include "robot/fit/radio/packet_ages.h"

#include <algorithm>
#include <random>

#include "robot/fit/radio/radio_model.h"

namespace robot::fit {
namespace {

constexpr std::size_t kAgePoints = 241;
constexpr double kOldestAge = 6, kSenderSilence = 10;  // [s]

/// A sum of the times in which a packet is older than each age.
class OlderThan {
 public:
  /// The newest packet ages from `from` to `to` [s].
  void add(double from, double to) {
    if (!(to > from) || to - from > kSenderSilence) return;
    time_ += to - from;
    for (std::size_t i = 0; i < kAgePoints; ++i) {
      const double age = age_of(i);
      if (age >= to) break;
      older_[i] += to - std::max(from, age);
    }
  }

  AgeCurve curve() const {
    AgeCurve curve;
    if (time_ <= 0) return curve;
    for (std::size_t i = 0; i < kAgePoints; ++i) {
      curve.ages.push_back(age_of(i));
      curve.shares.push_back(older_[i] / time_);
    }
    return curve;
  }

 private:
  static double age_of(std::size_t i) { return kOldestAge * static_cast<double>(i) / (kAgePoints - 1); }

  std::vector<double> older_ = std::vector<double>(kAgePoints);
  double time_ = 0;
};

}  // namespace

AgeCurve observed_ages(const std::vector<TeamRecord>& records) {
  OlderThan older;
  for (const TeamRecord& record : records) {
    std::vector<HeardPacket> last(256);
    std::vector<bool> known(last.size());
    for (const HeardPacket& packet : record.heard) {
      if (packet.mate >= last.size() || std::isnan(packet.arrived)) continue;
      const HeardPacket& before = last[packet.mate];
      if (known[packet.mate]) {
        const double sent = std::isnan(before.sent) ? before.arrived : before.sent;
        older.add(before.arrived - sent, packet.arrived - sent);
      }
      last[packet.mate] = packet;
      known[packet.mate] = true;
    }
  }
  return older.curve();
}

AgeCurve expected_ages(const std::vector<TeamRecord>& records, double delay, double loss) {
  std::mt19937_64 random(1);
  const auto uniform = [&random] { return static_cast<double>(random() >> 11) * 0x1p-53; };
  OlderThan older;
  for (const TeamRecord& record : records) {
    double sent = NAN, arrived = NAN;
    for (const SentPacket& packet : record.sent) {
      const double way = delay * std::min(kLongestDelayInMeans, -std::log(1 - uniform()));
      if (uniform() < loss) continue;
      if (!std::isnan(sent)) older.add(arrived - sent, packet.at + way - sent);
      sent = packet.at, arrived = packet.at + way;
    }
  }
  return older.curve();
}

}  // namespace robot::fit
