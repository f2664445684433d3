// The teams of a recorded ground truth.
#pragma once

#include <algorithm>
#include <cstdint>
#include <functional>
#include <map>
#include <string>
#include <utility>
#include <vector>

#include "robot/bridge/to_messages.h"
#include "robot/core/result.h"
#include "robot/memory/channel.h"

namespace robot::bridge {

/// Returns the two teams that are seen most in `truths`, the lower number as home. Each element has a GroundTruth as its
/// `value`. Returns an Error if fewer than two teams are seen.
template <class Truths>
Result<TeamNumbers> teams_seen(const Truths& truths) {
  std::map<std::uint32_t, std::size_t> seen;
  for (const auto& truth : truths)
    for (const auto& robot : truth.value.robots())
      if (robot.has_team()) ++seen[robot.team()];
  if (seen.size() < 2)
    return Error{std::string(memory::kTruthTopic) + ": expected robots of two teams, got " +
                 std::to_string(seen.size())};
  std::vector<std::pair<std::uint32_t, std::size_t>> by_count(seen.begin(), seen.end());
  std::ranges::stable_sort(by_count, std::greater<>(), &std::pair<std::uint32_t, std::size_t>::second);
  const auto [low, high] = std::minmax(by_count[0].first, by_count[1].first);
  return TeamNumbers{.home = low, .away = high};
}

}  // namespace robot::bridge
