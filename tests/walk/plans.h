// Plans that the bench and the search of parameters share.
#pragma once

#include <cstdint>

#include "robot/nao/walk/parameters.h"
#include "tests/walk/dice.h"
#include "tests/walk/trial.h"

namespace robot::nao::walk {

inline constexpr double kStart = 0.5;  // [s] a robot stands before it walks

/// Returns a number between 0 and 1 by its address.
inline double drawn(std::uint64_t seed, std::uint64_t number) { return Dice(seed * 1000003 + number).uniform(); }

/// A kick while walking: the step, and the place of the ball before the kicking foot.
struct PlannedKick {
  KickStep step = KickStep::forward;
  double speed = Parameters{}.kick_speed;       // [m/s] ahead
  double ball_ahead = Parameters{}.kick_reach;  // [m] from the torso, at most but for an error of 1.5 cm
  double nearer = 0.05;      // [m] the ball may lie this much nearer: a robot waits for the step of its foot
  double ball_aside = 0.06;  // [m] to the side of the foot
};

/// Returns the plan of a kick. The seed chooses the foot and the place of the ball.
inline Plan kick_plan(const PlannedKick& kick, std::uint64_t seed) {
  constexpr double kError = 0.015;  // [m]
  const Side foot = seed % 2 == 0 ? left : right;
  return {.duration = 7,
          .command =
              [=, step = kick.step, speed = kick.speed](double now) {
                if (now < kStart) return Command{};
                Command command{.forward = speed, .foot = foot};
                if (now > 3 && now < 3.55) command.kick = step;
                return command;
              },
          .pushes = {},
          .with_ball = true,
          .ball_ahead = kick.ball_ahead - kick.nearer * drawn(seed, 3) + kError * (2 * drawn(seed, 1) - 1),
          .ball_left = sign_of(foot) * (kick.ball_aside + 2 * kError * (2 * drawn(seed, 2) - 1))};
}

}  // namespace robot::nao::walk
