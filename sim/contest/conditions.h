// What robots might be like instead: the ranges over which a verdict is asked again.
#pragma once

#include <string>
#include <vector>

#include "sim/match/params.h"
#include "sim/match/state.h"

namespace sim::contest {

/// Factors upon what the models say.
struct Conditions {
  std::string name;         // "walk x0.8"; empty: as the models say
  float walk = 1;           // the speeds of everybody
  float kick = 1;           // the ranges of everybody's kicks
  float ball_noise = 1;     // the errors with which everybody sees the ball
  float opponent_pace = 1;  // walk and kick of the third behaviour, beyond the others'
};

/// The ranges of --robust: walk and kick 0.8 and 1.2, ball noise 0.5 and 2; with a third behaviour its pace, 0.8 and 1.2.
std::vector<Conditions> robust_conditions(bool third);

/// Puts them upon the models of a game; `opponent`: which side is the third behaviour's, nullptr: none.
void put_upon(const Conditions& conditions, const Side* opponent, Params& params);

}  // namespace sim::contest
