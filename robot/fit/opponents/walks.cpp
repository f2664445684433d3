#include "robot/fit/opponents/walks.h"

#include <algorithm>
#include <cmath>
#include <random>

#include "robot/fit/mean_path.h"
#include "sim/statistics/sample.h"

namespace robot::fit {
namespace {

// as in sim/statistics/walking.cpp
constexpr double kMeanReach = 1. / 6;                        // [s] before and after: 11 images
constexpr double kPerSecond = 10;                            // moments
constexpr std::size_t kMomentsApart = 10;                    // 1 s
constexpr double kStandingSpeed = 0.05, kFastestWalk = 0.8;  // [m/s]
constexpr std::size_t kFewestPlaces = 50;

constexpr double kTopShare = 0.99, kFastShare = 0.8;  // of its speeds; of the top speed
constexpr double kLeastWalked = 60;                   // [s]
constexpr double kLeastFast = 0.25;                   // share of the time that it walks
// In simulated games the top speed is 0.965 of the greatest possible one, give or take 0.02: steps differ, and turns cost speed.
constexpr double kTopOfPossible = 0.965, kTopError = 0.03;
constexpr std::size_t kDraws = 4000;

std::string team_of_robot(const std::string& robot) {
  const auto slash = robot.find('/');
  return slash == std::string::npos ? "" : robot.substr(0, slash);
}

bool lies(const lab::Path& path, double at) {
  const auto place = lab::place_at(path, at);
  return place && place->fallen.value_or(false);
}

}  // namespace

std::vector<SeenWalk> walks_in(const lab::TruthRecord& truth, const std::vector<std::string>& known,
                               std::size_t recording) {
  std::vector<SeenWalk> walks;
  for (const lab::TrueRobotPath& robot : truth.robots) {
    const MeanPath path(robot.path);
    if (std::ranges::find(known, robot.name) != known.end() || path.places().size() < kFewestPlaces) continue;
    SeenWalk walk{.recording = recording, .robot = robot.name, .team = team_of_robot(robot.name), .speeds = {}};
    const double start = path.places().front().at, end = path.places().back().at;
    const auto moments = static_cast<std::size_t>((end - start) * kPerSecond) + 1;
    std::vector<std::optional<MeanPath::Mean>> means;
    for (std::size_t i = 0; i < moments; ++i) {
      const double at = start + static_cast<double>(i) / kPerSecond;
      means.push_back(lies(path.places(), at) ? std::nullopt : path.over(at - kMeanReach, at + kMeanReach));
      if (i < kMomentsApart || !means[i] || !means[i - kMomentsApart]) continue;
      const MeanPath::Mean &now = *means[i], &before = *means[i - kMomentsApart];
      const double speed = std::hypot(now.x - before.x, now.y - before.y);
      if (speed < kFastestWalk) walk.speeds.push_back(speed);
    }
    if (!walk.speeds.empty()) walks.push_back(std::move(walk));
  }
  return walks;
}

std::optional<TopSpeed> top_speed_of(const SeenWalk& walk) {
  const double top = sim::statistics::quantile(walk.speeds, kTopShare);
  double walks = 0, hurries = 0;
  for (const double speed : walk.speeds) {
    if (speed > kStandingSpeed) walks += 1;
    if (speed > kFastShare * top) hurries += 1;
  }
  if (walks < kLeastWalked * kPerSecond || hurries < kLeastFast * walks) return std::nullopt;
  const double possible = top / kTopOfPossible;
  return TopSpeed{.value = possible, .deviation = kTopError * possible};
}

PaceFit fit_paces(const std::vector<TopSpeed>& tops) {
  std::mt19937_64 random(1);
  const auto uniform = [&] { return (static_cast<double>(random() >> 11) + 0.5) * 0x1p-53; };
  const auto normal = [&] { return std::sqrt(-2 * std::log(uniform())) * std::cos(6.283185307179586 * uniform()); };
  const auto n = static_cast<double>(tops.size());
  const auto [slowest, fastest] = std::ranges::minmax_element(tops, {}, &TopSpeed::value);
  std::vector<double> forwards, spreads;
  for (std::size_t i = 0; i < kDraws; ++i) {
    // the ends of a range of which n values are known: P((end - most) / (most - least) > t) = (1 + t)^(1 - n)
    const double end = fastest->value + (fastest->value - slowest->value) * (std::pow(uniform(), -1 / (n - 1)) - 1);
    const double begin = std::max(0., end - (end - slowest->value) * std::pow(uniform(), -1 / n));
    forwards.push_back(end + fastest->deviation * normal());
    spreads.push_back(std::clamp(1 - (begin + slowest->deviation * normal()) / forwards.back(), 0., 1.));
  }
  const auto at = [](const std::vector<double>& values, double share) {
    return sim::statistics::quantile(values, share);
  };
  return {.forward = at(forwards, 0.5),
          .forward_low = at(forwards, 0.025),
          .forward_high = at(forwards, 0.975),
          .spread = at(spreads, 0.5),
          .spread_low = at(spreads, 0.025),
          .spread_high = at(spreads, 0.975)};
}

}  // namespace robot::fit
