#include "sim/statistics/ball_path.h"

#include <algorithm>
#include <cmath>

#include "sim/statistics/sample.h"

namespace sim::statistics {
namespace {

constexpr std::size_t frames_in(double seconds) {
  return static_cast<std::size_t>(0.5 * (2 * seconds * kFramesPerSecond + 1));
}

constexpr std::size_t kLongestGap = 10;             // frames from one known place to the next: 0.35 s
constexpr std::size_t kMedianReach = 3;             // frames before and after
constexpr std::size_t kSpeedSpan = frames_in(0.2);  // frames
constexpr double kFastestBall = 4;                  // [m/s]
constexpr double kKick = 0.5, kRise = 0.4;          // [m/s] a kick; speed from which one is looked for
constexpr double kRolledOut = 0.1;                  // [m/s]
constexpr float kRestRadius = 0.15f;                // [m]
constexpr std::size_t kPeakSpan = frames_in(0.6);   // in which the peak lies
constexpr std::size_t kBefore = frames_in(0.6);     // the speed before a kick: from here
constexpr std::size_t kShortlyBefore = 4;           // to here
constexpr std::size_t kAfterPeak = frames_in(0.3);  // before the next kick can begin
constexpr std::size_t kLongestRoll = frames_in(8);

Path filled(const Path& seen) {
  Path path = seen;
  std::optional<std::size_t> last;
  for (std::size_t i = 0; i < seen.size(); ++i) {
    if (!seen[i]) continue;
    if (last && i - *last > 1 && i - *last <= kLongestGap)
      for (std::size_t gap = *last + 1; gap < i; ++gap) {
        const float part = static_cast<float>(gap - *last) / static_cast<float>(i - *last);
        path[gap] = *seen[*last] + part * (*seen[i] - *seen[*last]);
      }
    last = i;
  }
  return path;
}

/// Returns the median of each coordinate in the frames around `at`.
Vec2 median_around(const Path& path, std::size_t at) {
  std::vector<double> x, y;
  const std::size_t end = std::min(path.size(), at + kMedianReach + 1);
  for (std::size_t i = at < kMedianReach ? 0 : at - kMedianReach; i < end; ++i)
    if (path[i]) x.push_back(static_cast<double>(path[i]->x)), y.push_back(static_cast<double>(path[i]->y));
  if (x.size() < 3) return *path[at];
  return {static_cast<float>(median(std::move(x))), static_cast<float>(median(std::move(y)))};
}

/// Returns the known speeds of the frames from .. to - 1.
std::vector<double> known(const Speeds& speeds, std::size_t from, std::size_t to) {
  std::vector<double> values;
  for (std::size_t i = from; i < std::min(to, speeds.size()); ++i)
    if (speeds[i]) values.push_back(*speeds[i]);
  return values;
}

/// Returns the frame of the greatest speed within the span of a peak; `speeds[from]` is known.
std::size_t peak_after(const Speeds& speeds, std::size_t from) {
  std::size_t peak = from;
  for (std::size_t i = from; i < std::min(from + kPeakSpan, speeds.size()); ++i)
    if (speeds[i] && *speeds[i] > *speeds[peak]) peak = i;
  return peak;
}

std::optional<double> roll_of(const Path& smooth, const Speeds& speeds, std::size_t from, std::size_t peak) {
  std::size_t end = peak;
  while (end + 1 < speeds.size() && speeds[end] && *speeds[end] > kRolledOut && end - peak < kLongestRoll) ++end;
  if (!smooth[end] || !smooth[from]) return std::nullopt;
  return static_cast<double>(distance(*smooth[from], *smooth[end]));
}

/// The frames after some frame in which the ball stays near its place.
struct Rest {
  std::size_t end;         // behind the last frame with the ball near
  std::size_t frames = 0;  // with a ball
};

Rest rest_from(const Path& smooth, std::size_t from) {
  Rest rest{.end = from};
  for (std::size_t i = from; i < smooth.size(); ++i) {
    if (!smooth[i]) {
      if (i == from) break;
      continue;
    }
    if (distance(*smooth[from], *smooth[i]) > kRestRadius) break;
    rest.end = i + 1, ++rest.frames;
  }
  return rest;
}

}  // namespace

Path smoothed(const Path& seen) {
  const Path path = filled(seen);
  Path smooth = path;
  for (std::size_t i = 0; i < path.size(); ++i)
    if (path[i]) smooth[i] = median_around(path, i);
  return smooth;
}

Speeds speeds_of(const Path& smooth) {
  Speeds speeds(smooth.size());
  for (std::size_t i = 0; i + kSpeedSpan < smooth.size(); ++i) {
    const std::optional<Vec2>&from = smooth[i], &to = smooth[i + kSpeedSpan];
    if (!from || !to) continue;
    const double speed = static_cast<double>(distance(*from, *to)) * kFramesPerSecond / kSpeedSpan;
    if (speed <= kFastestBall) speeds[i] = speed;
  }
  return speeds;
}

std::vector<Kick> kicks_in(const Path& smooth, const Speeds& speeds) {
  std::vector<Kick> kicks;
  for (std::size_t i = 0; i < speeds.size(); ++i) {
    if (!speeds[i] || *speeds[i] <= kRise) continue;
    const std::size_t from = i < kBefore ? 0 : i - kBefore;
    const std::size_t to = i < kShortlyBefore ? 1 : std::max<std::size_t>(1, i - kShortlyBefore);
    const std::vector<double> before = known(speeds, from, to);
    const std::size_t peak = peak_after(speeds, i);
    if (before.empty() || *speeds[peak] <= std::max(kKick, 2 * median(before))) continue;
    kicks.push_back({.frame = i, .speed = *speeds[peak], .roll = roll_of(smooth, speeds, i, peak)});
    i = peak + kAfterPeak - 1;
  }
  return kicks;
}

double share_at_rest(const Path& smooth, double seconds) {
  const double least = seconds * kFramesPerSecond;
  std::size_t resting = 0;
  for (std::size_t i = 0; i < smooth.size();) {
    const Rest rest = rest_from(smooth, i);
    const bool is_long = static_cast<double>(rest.end - i) > least;
    if (is_long) resting += rest.frames;
    i = is_long ? rest.end : i + 1;
  }
  const auto all = std::ranges::count_if(smooth, [](const auto& ball) { return ball.has_value(); });
  return ratio(static_cast<double>(resting), static_cast<double>(all));
}

double displacement_after(const Path& smooth, double seconds) {
  const std::size_t span = frames_in(seconds);
  std::vector<double> values;
  for (std::size_t i = 0; i + span < smooth.size(); ++i)
    if (smooth[i] && smooth[i + span]) values.push_back(static_cast<double>(distance(*smooth[i], *smooth[i + span])));
  return median(std::move(values));
}

}  // namespace sim::statistics
