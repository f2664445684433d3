#include "tests/sim/statistics/windows.h"

#include <cmath>

#include "sim/math/random.h"

namespace tests {

using namespace sim;
using namespace sim::statistics;

namespace {

std::size_t frames_in(double seconds) { return static_cast<std::size_t>(seconds * kFramesPerSecond + 0.5); }

Vec2 disturbed(Vec2 place, float deviation, std::uint32_t robot, std::size_t frame) {
  const auto words = draw({.seed = 5}, robot, Draw::situation, static_cast<std::uint32_t>(frame));
  const auto noise = normals(words[0], words[1]);
  return {place.x + deviation * noise[0], place.y + deviation * noise[1]};
}

/// A ball that is kicked every 12 s with 1.2 m/s, forth and back, and that slows by 0.5 m/s².
Vec2 kicked_ball(double seconds) {
  const double round = std::fmod(seconds, 24), since = std::fmod(round, 12), rolling = std::min(since, 2.4);
  const double way = 1.2 * rolling - 0.25 * rolling * rolling;  // 1.44 m
  return {static_cast<float>(round < 12 ? 0.2 + way : 1.64 - way), 0.3f};
}

}  // namespace

Path path_of(double seconds, const std::function<std::optional<Vec2>(double)>& place) {
  Path path;
  for (std::size_t i = 0; i < frames_in(seconds); ++i) path.push_back(place(static_cast<double>(i) / kFramesPerSecond));
  return path;
}

Robot robot_of(int side, int player, double seconds, const std::function<std::optional<Sighting>(double)>& place) {
  Robot robot{.side = side, .player = player, .frames = {}};
  for (std::size_t i = 0; i < frames_in(seconds); ++i)
    robot.frames.push_back(place(static_cast<double>(i) / kFramesPerSecond));
  return robot;
}

Window small_game() {
  constexpr double kSeconds = 60;
  Window window;
  window.ball = path_of(kSeconds, kicked_ball);
  for (const int side : {0, 1})
    for (const int player : {1, 2, 3, 4})
      window.robots.push_back(robot_of(side, player, kSeconds, [=](double seconds) {
        const float sign = side == 0 ? -1.f : 1.f;
        const auto around = static_cast<float>(player) * 0.2f + 0.15f * static_cast<float>(seconds);
        const Vec2 middle{sign * (0.4f * static_cast<float>(player)), 0.5f * static_cast<float>(player) - 1};
        return Sighting{.position = middle + direction(around), .down = player == 2 && seconds > 20 && seconds < 24};
      }));
  return window;
}

Window with_noise(Window window, float deviation) {
  for (std::size_t i = 0; i < window.size(); ++i)
    if (window.ball[i]) window.ball[i] = disturbed(*window.ball[i], deviation, 99, i);
  for (std::size_t robot = 0; robot < window.robots.size(); ++robot)
    for (std::size_t i = 0; i < window.size(); ++i)
      if (auto& seen = window.robots[robot].frames[i])
        seen->position = disturbed(seen->position, deviation, static_cast<std::uint32_t>(robot), i);
  return window;
}

}  // namespace tests
