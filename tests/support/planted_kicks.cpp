#include "tests/support/planted_kicks.h"

#include <algorithm>
#include <cmath>
#include <random>

namespace robot::tests {

KickedBalls kicked_balls(const PlantedKicks& planted, std::uint64_t seed) {
  constexpr int kImages = 240;  // 8 s
  std::mt19937_64 random(seed);
  std::normal_distribution<double> normal;
  std::uniform_real_distribution<double> uniform;
  KickedBalls game;
  game.truth.ball_deviation = std::max(0.001, planted.truth_error);
  for (std::size_t kick = 0; kick < planted.kicks; ++kick) {
    const double start = 8. * static_cast<double>(kick), heading = 6 * uniform(random) - 3;
    const double robot_x = uniform(random), robot_y = uniform(random), side = kick % 2 == 0 ? 1 : -1;
    const double c = std::cos(heading), s = std::sin(heading);
    const double rest_x = robot_x + 0.18 * c - side * 0.05 * s, rest_y = robot_y + 0.18 * s + side * 0.05 * c;
    const double share = uniform(random) < planted.model.partial ? uniform(random) : 1;
    const double range = std::max(0., 1 + planted.model.range_deviation * normal(random));
    const double speed = share * planted.model.speed * std::sqrt(range);
    const double spread = planted.spread - (planted.spread - 1) * share;
    const double angle =
        heading + side * (planted.model.direction + spread * planted.model.direction_deviation * normal(random));
    const double begin = start + 2 + uniform(random) / 30;
    game.runs.push_back({.kind = "forward", .left = side > 0, .begin = begin, .end = begin + 1.5});
    for (int i = 0; i < kImages; ++i) {
      const double at = start + i / 30.;
      const double rolls = std::clamp(at - begin - planted.delay, 0., speed / planted.deceleration);
      const double way = speed * rolls - planted.deceleration * rolls * rolls / 2;
      const auto seen = [&](double place) { return place + planted.truth_error * normal(random); };
      game.truth.ball.push_back(
          {.at = at, .x = seen(rest_x + way * std::cos(angle)), .y = seen(rest_y + way * std::sin(angle))});
      game.robot.push_back({.at = at, .x = seen(robot_x), .y = seen(robot_y), .heading = heading});
    }
  }
  game.truth.robots.push_back({.name = "14/2", .path = game.robot});
  return game;
}

}  // namespace robot::tests
