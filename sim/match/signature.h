// The simulator's signature: one hash that changes when, and only when, the simulator behaves differently.
#pragma once

#include <cstdint>
#include <vector>

#include "sim/match/params.h"
#include "sim/match/state.h"

namespace sim {

inline constexpr int kScenarios = 64;
inline constexpr int kScenarioSteps = 600;

/// The data from which scenarios are built. The order in each list matters; none of the lists is empty.
struct Ingredients {
  std::vector<field::Rules> rules;
  std::vector<Models> models;
  std::vector<const agent::Behaviour*> behaviours;
};

/// The start of a short game.
struct Scenario {
  Params params;
  State start;
};

/// Returns scenario 0..63. The number settles rules, players a side (1..7), behaviours, models and pace; some effects
/// of the models are switched over. Even scenarios start with the kick-off, odd ones in the middle of a game.
Scenario scenario(const Ingredients& ingredients, int number);

/// Plays every scenario for 600 steps and returns a hash of the states, once a second, and of all events. The hash is
/// the same on every machine and in every build.
std::uint64_t signature_of(const Ingredients& ingredients);

}  // namespace sim
