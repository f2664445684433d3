// A strategy on the physics robot: it walks to the ball and kicks it, until the ball is in the goal.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "tests/walk/drawn_robot.h"

namespace robot::nao {

/// The deeds of one robot.
struct Played {
  bool scored = false, fell = false;
  double seconds = 0;         // until the goal, the fall or the end
  std::vector<double> kicks;  // [m/s] the fastest ball in the half second after each step that kicked
  std::vector<double> waits;  // [s] from the first command of each kick to its step
  std::string trouble;        // the sentence of the behaviour or the motions that refused something; empty: none did
};

/// Lets the robot of this seed play alone, from beliefs with errors to the joints, for at most `seconds`. The ball lies 0.7 m
/// ahead and up to 0.25 m to one side, 1.8 m before the goal. The robot has the usual strategy and the models `nao`.
Played play_alone(walk::Servos servos, std::uint64_t seed, double seconds);

}  // namespace robot::nao
