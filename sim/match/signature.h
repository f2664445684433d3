// One number for everything that the simulator does: it changes exactly when games do.
#pragma once

#include <cstdint>
#include <vector>

#include "sim/match/params.h"
#include "sim/match/state.h"

namespace sim {

inline constexpr int kScenarios = 64;
inline constexpr int kScenarioSteps = 600;

/// What the scenarios are made of, each in an order that stays; none of the lists is empty.
struct Ingredients {
  std::vector<field::Rules> rules;
  std::vector<Models> models;
  std::vector<const agent::Behaviour*> behaviours;
};

/// Scenario 0..63: its rules, how many play (1..7 a side), behaviours, models, some of whose effects are turned over,
/// and pace; even ones begin a game, odd ones in the middle of one.
struct Scenario {
  Params params;
  State start;
};
Scenario scenario(const Ingredients& ingredients, int number);

/// Plays every scenario for 600 steps and hashes the states on the way, once a second, and every event. The same on
/// every machine and in every build.
std::uint64_t signature_of(const Ingredients& ingredients);

}  // namespace sim
