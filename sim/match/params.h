// Everything that stays constant during a game.
#pragma once

#include <memory>
#include <string>

#include "sim/agent/behaviour.h"
#include "sim/field/rules.h"
#include "sim/motion/model.h"
#include "sim/perception/model.h"
#include "sim/world/effects.h"
#include "sim/world/model.h"
#include "sim/world/world.h"

namespace sim {

/// A model of reality, read from a file in sim/data/models.
struct Models {
  std::string name;
  Effects effects;
  BallModel ball;
  ContactModel contact;
  motion::Model motion;
  perception::Model perception;
};

/// The behaviour and the abilities of one side.
struct Team {
  const agent::Behaviour* behaviour = nullptr;  // not owned; outlives the game
  Models models;                                // of its robots; for ball and contacts the home side's count
  // By player - 1: the models of a robot that differs from the others. nullptr: `models`. Their ball and contacts do not
  // count.
  std::shared_ptr<const Models> single[kMaxPlayers];

  /// Returns the models of a robot by its player number, 1 .. kMaxPlayers.
  const Models& models_of(int player) const {
    const Models* const own = single[player - 1].get();
    return own ? *own : models;
  }
};

/// How often robots perceive and decide: each tick, or less often far from the ball (sim/match/pace.h).
/// `scripts/bench equivalence` measures the difference.
enum class Pace : unsigned char { every_tick, thinned };

/// The parameters of a game.
struct Params {
  field::Rules rules;
  field::Marks marks;  // of rules.field
  Team teams[2];       // by Side
  Pace pace = Pace::thinned;
};

/// Returns the models of a robot by its index.
inline const Models& models_of(const Params& params, int robot) {
  return params.teams[static_cast<int>(side_of(robot))].models_of(player_of(robot));
}

/// Replaces the ball of the models by that of the rules, if the rules have one.
inline void take_ball_of_rules(Params& params) {
  if (params.rules.ball_radius > 0)
    for (Team& team : params.teams) team.models.ball.radius = params.rules.ball_radius;
}

}  // namespace sim
