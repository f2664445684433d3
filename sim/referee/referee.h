// The referee: which rule is due, and what it does. One rule per file in this folder.
#pragma once

#include "sim/agent/beliefs.h"
#include "sim/field/rules.h"
#include "sim/referee/book.h"
#include "sim/referee/event.h"
#include "sim/world/model.h"
#include "sim/world/world.h"

namespace sim::referee {

/// What judging depends on; none of it changes during a game.
struct RefereeParams {
  const field::Rules& rules;
  const BallModel& ball;
  const ContactModel& contact;
};

/// Opens a game: everybody outside at the touch line, ready for the kick-off of the side that the key draws.
void open(const RefereeParams& params, World& world, Book& book, Events& events);

/// Looks at the world after everybody moved and applies the rules that are due. Moves the ball and removed robots;
/// where those come back, `perception::enter` is called by whoever steps the game.
void judge(const RefereeParams& params, World& world, Book& book, GameCounts& counts, Events& events);

/// [s] of the half that are still to be played; the half ends with the first tick at which none are.
float left_of_half(const field::Rules& rules, const Book& book);

/// [s] after which that part of the game ends by itself: READY, and a kick-off or set play in PLAYING. 0: it does not.
float countdown_of(const field::Rules& rules, agent::Game::Phase phase, agent::Game::SetPlay set_play);

/// What the GameController tells a robot now.
agent::Game game_for(const field::Rules& rules, const World& world, const Book& book, int robot);

}  // namespace sim::referee
