// What stays the same during a game.
#pragma once

#include <string>

#include "sim/agent/behaviour.h"
#include "sim/field/rules.h"
#include "sim/motion/model.h"
#include "sim/perception/model.h"
#include "sim/world/effects.h"
#include "sim/world/model.h"

namespace sim {

/// A model of reality, as a file in sim/data/models describes it.
struct Models {
  std::string name;
  Effects effects;
  BallModel ball;
  ContactModel contact;
  motion::Model motion;
  perception::Model perception;
};

/// How one side plays and what its robots can do.
struct Team {
  const agent::Behaviour* behaviour = nullptr;  // outlives the game
  Models models;                                // of these robots; ball and contacts are the home side's
};

/// Robots far from the ball may sense and decide less often; scripts/bench equivalence shows what that changes.
enum class Pace : unsigned char { every_tick, thinned };

struct Params {
  field::Rules rules;
  field::Marks marks;  // of rules.field
  Team teams[2];       // by Side
  Pace pace = Pace::thinned;
};

}  // namespace sim
