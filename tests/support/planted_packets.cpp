#include "tests/support/planted_packets.h"

#include <algorithm>
#include <cmath>
#include <memory>
#include <random>
#include <string>

namespace robot::tests {
namespace {

double rounded(double seconds, bool to_ticks) { return to_ticks ? std::round(seconds * 30) / 30 : seconds; }

}  // namespace

std::vector<fit::TeamRecord> planted_packets(const PlantedPackets& planted, std::uint64_t seed) {
  std::mt19937_64 random(seed);
  std::normal_distribution<double> normal;
  std::uniform_real_distribution<double> uniform;
  const auto game = std::make_shared<const fit::TrueGame>(fit::TrueGame{.name = "game", .record = {}});
  std::vector<fit::TeamRecord> records(planted.robots);
  std::vector<double> clock(planted.robots);
  for (unsigned i = 0; i < planted.robots; ++i) {
    clock[i] = planted.clock_error * normal(random);
    records[i].name = "robot " + std::to_string(i + 1);
    records[i].robot = "14/" + std::to_string(i + 1);
    records[i].game = game;
    records[i].clock_deviation = planted.clock_error;
    records[i].simulated = planted.ticks;
    for (double at = 0; at < 60 * planted.minutes + 5; at += 0.5) records[i].written.push_back(at);
  }
  for (unsigned sender = 0; sender < planted.robots; ++sender) {
    std::uint32_t number = 0;
    double next = rounded(uniform(random), planted.ticks);
    while (next < 60 * planted.minutes) {
      const double at = next;
      records[sender].sent.push_back({.at = at + clock[sender], .number = ++number});
      const double way = planted.delay * std::min(5., -std::log(1 - uniform(random)));
      const double arrived = at + rounded(way, planted.ticks);
      for (unsigned receiver = 0; receiver < planted.robots; ++receiver) {
        if (receiver == sender || uniform(random) < planted.loss) continue;
        records[receiver].heard.push_back({.mate = sender + 1,
                                           .sent = planted.dated ? at + clock[sender] : NAN,
                                           .arrived = arrived + clock[receiver],
                                           .shown = arrived + clock[receiver] + (planted.ticks ? fit::kTick : 0),
                                           .ball_age = 0.1,
                                           .x = 0.1 * at - std::floor(0.1 * at),
                                           .y = 0});
      }
      const double pause = planted.interval + planted.jitter * uniform(random);
      // a simulated robot has one packet on the air
      next = planted.ticks ? std::max(arrived, at + rounded(pause, true)) : at + pause;
    }
  }
  for (fit::TeamRecord& record : records) std::ranges::stable_sort(record.heard, {}, &fit::HeardPacket::arrived);
  return records;
}

}  // namespace robot::tests
