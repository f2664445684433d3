// Other assumptions about robots, under which a verdict is tested again.
#pragma once

#include <string>
#include <vector>

#include "sim/match/params.h"
#include "sim/match/state.h"

namespace sim::contest {

/// Factors on the models.
struct Conditions {
  std::string name;         // such as "walk x0.8"; empty: unchanged models
  float walk = 1;           // speeds of all robots
  float kick = 1;           // ranges of all kicks
  float ball_noise = 1;     // errors of all robots' ball perception
  float opponent_pace = 1;  // walk and kick of the third behaviour, in addition
};

/// Returns the conditions of --robust: walk and kick 0.8 and 1.2, ball noise 0.5 and 2. With a third behaviour also its pace,
/// 0.8 and 1.2.
std::vector<Conditions> robust_conditions(bool third);

/// Applies the conditions to the models of a game. `opponent` is the side of the third behaviour, or null.
void put_upon(const Conditions& conditions, const Side* opponent, Params& params);

}  // namespace sim::contest
