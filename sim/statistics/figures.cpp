#include "sim/statistics/figures.h"

#include <algorithm>
#include <cmath>

#include "sim/statistics/ball_path.h"
#include "sim/statistics/crowd.h"
#include "sim/statistics/sample.h"
#include "sim/statistics/walking.h"

namespace sim::statistics {
namespace {

constexpr double kFast = 0.5, kFastKick = 1;  // [m/s]
constexpr double kRest = 10;                  // [s]
constexpr float kMiddle = 1.5f;               // [m] from the middle line

void measure_kicks(const std::vector<Kick>& kicks, double minutes, Figures& figures) {
  std::vector<double> rolls;
  for (const Kick& kick : kicks)
    if (kick.roll) rolls.push_back(*kick.roll);
  const auto count = static_cast<double>(kicks.size());
  const auto fast =
      static_cast<double>(std::ranges::count_if(kicks, [](const Kick& kick) { return kick.speed > kFastKick; }));
  figures.kicks = ratio(count, minutes);
  figures.fast_kicks = ratio(fast, minutes);
  figures.fast_kick_share = ratio(fast, count);
  figures.roll_median = median(rolls);
  figures.roll_90 = quantile(std::move(rolls), 0.9);
}

void measure_ball(const Path& path, Figures& figures) {
  const Speeds speeds = speeds_of(path);
  std::vector<double> known;
  Share fast, middle;
  for (const std::optional<double>& speed : speeds)
    if (speed) known.push_back(*speed), fast.add(*speed > kFast);
  for (const std::optional<Vec2>& ball : path)
    if (ball) middle.add(std::abs(ball->x) < kMiddle);
  measure_kicks(kicks_in(path, speeds), static_cast<double>(known.size()) / kFramesPerSecond / 60, figures);
  figures.ball_fast = fast.value();
  figures.ball_speed = mean_of(known);
  figures.ball_still = share_at_rest(path, kRest);
  figures.displacement_10 = displacement_after(path, 10);
  figures.displacement_30 = displacement_after(path, 30);
  figures.middle = middle.value();
}

void measure_room(const Window& window, const Path& path, Figures& figures) {
  const NearBall near = near_ball(window, path);
  figures.nearest = near.nearest, figures.second = near.second, figures.third = near.third;
  figures.nobody_1m = near.nobody_1m, figures.both_60cm = near.both_60cm, figures.both_1m = near.both_1m;
  const Room room = room_between(window);
  figures.mates = room.mates, figures.close = room.close;
  figures.extent_x = room.extent_x, figures.extent_y = room.extent_y;
}

void measure_walking(const Window& window, Figures& figures) {
  const Walking walking = walking_of(window);
  figures.standing = walking.standing;
  figures.walking_median = walking.speed_median, figures.walking_99 = walking.speed_99;
  figures.walked = walking.metres_per_minute;
  figures.falls = walking.falls_per_minute, figures.down = walking.down;
}

}  // namespace

Figures measure(const Window& window) {
  Figures figures;
  const Path path = smoothed(window.ball);
  measure_ball(path, figures);
  measure_room(window, path, figures);
  measure_walking(window, figures);
  return figures;
}

}  // namespace sim::statistics
