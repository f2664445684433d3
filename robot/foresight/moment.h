// A moment, and how long before it something was.
#pragma once

#include <algorithm>
#include <cstdint>

namespace robot::foreseeing {

struct Moment {
  std::uint64_t now_ns = 0;  // [ns since the epoch]
  double speed = 1;          // [game seconds per second] of a simulation

  /// [ns] of game time since `then_ns`, at most 30 years; 0 where that is still to come.
  std::uint64_t since(std::uint64_t then_ns) const {
    constexpr double kMost = 1e18;
    const std::uint64_t passed_ns = now_ns > then_ns ? now_ns - then_ns : 0;
    return static_cast<std::uint64_t>(std::min(static_cast<double>(passed_ns) * speed, kMost));
  }

  /// Time was moved back since, as where a recording begins again. What is written while the moment is looked at is no
  /// more than a second later.
  bool is_before(std::uint64_t then_ns) const { return then_ns > now_ns + kAtOnceNs; }

  static constexpr std::uint64_t kAtOnceNs = 1'000'000'000;
};

}  // namespace robot::foreseeing
