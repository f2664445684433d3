// The referee: applies the rules that are due. Each rule is one file in this folder.
#pragma once

#include "sim/agent/beliefs.h"
#include "sim/field/rules.h"
#include "sim/referee/book.h"
#include "sim/referee/event.h"
#include "sim/world/model.h"
#include "sim/world/world.h"

namespace sim::referee {

/// The parameters of the referee. They are constant during a game.
struct RefereeParams {
  const field::Rules& rules;
  const BallModel& ball;
  const ContactModel& contact;
};

/// Opens a game: all robots stand at the touch lines, in READY for the kick-off.
/// Draw::kick_off selects the kicking side.
void open(const RefereeParams& params, World& world, Book& book, Events& events);

/// Judges the world after all robots have moved: applies the rules that are due. Moves the ball and removed robots.
/// For a robot that comes back, the caller must call `perception::enter`.
void judge(const RefereeParams& params, World& world, Book& book, GameCounts& counts, Events& events);

/// Returns the remaining time of the half [s]. The half ends with the first tick at which it is 0 or less.
float left_of_half(const field::Rules& rules, const Book& book);

/// Returns the time after which READY, or a kick-off or set play in PLAYING, ends by itself [s]. 0: it does not end so.
float countdown_of(const field::Rules& rules, agent::Game::Phase phase, agent::Game::SetPlay set_play);

/// Returns the GameController's message to a robot at this moment.
agent::Game game_for(const field::Rules& rules, const World& world, const Book& book, int robot);

}  // namespace sim::referee
