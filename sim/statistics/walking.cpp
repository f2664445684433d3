#include "sim/statistics/walking.h"

#include <algorithm>

#include "sim/statistics/sample.h"

namespace sim::statistics {
namespace {

constexpr std::size_t kFewestFrames = 50;
constexpr std::size_t kReach = 5;                         // frames averaged before and after
constexpr std::size_t kSpeedStride = 3;                   // [frames]
constexpr std::size_t kSpan = 10;                         // [strides] 1 s
constexpr double kStanding = 0.05, kFastestWalk = 0.8;    // [m/s]
constexpr std::size_t kDownBefore = 15, kDownAfter = 15;  // frames around: from - 15 to + 14
constexpr int kDownFrames = 22;

using Frames = std::vector<std::optional<Sighting>>;

std::size_t seen_frames(const Frames& frames) {
  return static_cast<std::size_t>(std::ranges::count_if(frames, [](const auto& seen) { return seen.has_value(); }));
}

/// Returns the mean place in the frames around `at`, or nothing if the robot is in none of them.
std::optional<Vec2> mean_around(const Frames& frames, std::size_t at) {
  double x = 0, y = 0;
  int count = 0;
  for (std::size_t i = at < kReach ? 0 : at - kReach; i < std::min(frames.size(), at + kReach + 1); ++i)
    if (frames[i])
      x += static_cast<double>(frames[i]->position.x), y += static_cast<double>(frames[i]->position.y), ++count;
  if (count == 0) return std::nullopt;
  return Vec2{static_cast<float>(x / count), static_cast<float>(y / count)};
}

void add_speeds(const Frames& frames, std::vector<double>& speeds) {
  Path places;
  for (std::size_t i = 0; i < frames.size(); i += kSpeedStride) places.push_back(mean_around(frames, i));
  for (std::size_t i = 0; i + kSpan < places.size(); ++i) {
    if (!places[i] || !places[i + kSpan]) continue;
    const double speed = static_cast<double>(distance(*places[i], *places[i + kSpan]));  // over 1 s
    if (speed < kFastestWalk) speeds.push_back(speed);
  }
}

/// Reports whether the robot is down in most frames around `at`.
bool lies_around(const Frames& frames, std::size_t at) {
  int down = 0;
  for (std::size_t i = at < kDownBefore ? 0 : at - kDownBefore; i < std::min(frames.size(), at + kDownAfter); ++i)
    down += frames[i] && frames[i]->down ? 1 : 0;
  return down >= kDownFrames;
}

}  // namespace

Walking walking_of(const Window& window) {
  std::vector<double> speeds;
  double seen = 0, down = 0, falls = 0;
  for (const Robot& robot : window.robots) {
    const std::size_t count = seen_frames(robot.frames);
    if (count < kFewestFrames) continue;
    seen += static_cast<double>(count);
    add_speeds(robot.frames, speeds);
    bool lay = true;  // a robot that lies when the window begins fell before
    for (std::size_t i = 0; i < robot.frames.size(); ++i) {
      const bool lies = lies_around(robot.frames, i);
      if (lies && !lay) ++falls;
      down += lies ? 1 : 0;
      lay = lies;
    }
  }
  std::vector<double> walking;
  std::ranges::copy_if(speeds, std::back_inserter(walking), [](double speed) { return speed > kStanding; });
  const auto standing = std::ranges::count_if(speeds, [](double speed) { return speed < kStanding; });
  const double minutes = seen / kFramesPerSecond / 60;
  return {.standing = ratio(static_cast<double>(standing), static_cast<double>(speeds.size())),
          .speed_median = median(std::move(walking)),
          .speed_99 = quantile(speeds, 0.99),
          .metres_per_minute = 60 * mean_of(speeds),
          .falls_per_minute = ratio(falls, minutes),
          .down = ratio(down, seen)};
}

}  // namespace sim::statistics
