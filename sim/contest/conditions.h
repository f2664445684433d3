// Other models of the robots: the ranges over which --robust repeats a verdict.
#pragma once

#include <string>
#include <vector>

#include "sim/match/params.h"
#include "sim/match/state.h"

namespace sim::contest {

/// Factors on the figures of the models.
struct Conditions {
  std::string name;         // "walk x0.8"; empty: the models as they are
  float walk = 1;           // speeds of all robots
  float kick = 1;           // ranges of all robots' kicks
  float ball_noise = 1;     // errors with which all robots see the ball
  float opponent_pace = 1;  // walk and kick of the third behaviour, on top of the factors above
};

/// Returns the ranges of --robust: walk and kick 0.8 and 1.2, ball noise 0.5 and 2. With a third behaviour also its
/// pace, 0.8 and 1.2.
std::vector<Conditions> robust_conditions(bool third);

/// Scales the models of a game. `opponent` is the side of the third behaviour, or nullptr without one.
void put_upon(const Conditions& conditions, const Side* opponent, Params& params);

}  // namespace sim::contest
