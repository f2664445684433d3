// Plans that the bench and the search of parameters share.
#pragma once

#include <cstdint>

#include "tests/walk/dice.h"
#include "tests/walk/trial.h"

namespace robot::nao::walk {

inline constexpr double kStart = 0.5;  // [s] a robot stands before it walks

/// Returns a number between 0 and 1 by its address.
inline double drawn(std::uint64_t seed, std::uint64_t number) { return Dice(seed * 1000003 + number).uniform(); }

/// A kick while walking: the step, and the place of the ball before the kicking foot.
struct PlannedKick {
  KickStep step = KickStep::forward;
  double ball_ahead = 0.185;  // [m] from the torso
  double ball_aside = 0.05;   // [m] to the side of the foot
};

/// Returns the plan of a kick. The seed chooses the foot, and puts the ball beside its place by at most 15 mm.
inline Plan kick_plan(const PlannedKick& kick, std::uint64_t seed) {
  constexpr double kError = 0.015;  // [m]
  const Side foot = seed % 2 == 0 ? left : right;
  return {.duration = 7,
          .command =
              [=, step = kick.step](double now) {
                if (now < kStart) return Command{};
                Command command{.forward = 0.1, .foot = foot};
                if (now > 3 && now < 3.55) command.kick = step;
                return command;
              },
          .pushes = {},
          .with_ball = true,
          .ball_ahead = kick.ball_ahead + kError * (2 * drawn(seed, 1) - 1),
          .ball_left = sign_of(foot) * (kick.ball_aside + kError * (2 * drawn(seed, 2) - 1))};
}

}  // namespace robot::nao::walk
