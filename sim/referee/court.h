// The data that every rule works on, and the actions that several rules share.
#pragma once

#include <cmath>

#include "sim/referee/referee.h"

namespace sim::referee {

using Phase = agent::Game::Phase;
using SetPlay = agent::Game::SetPlay;
using Doing = Body::Doing;

/// One tick from the referee's view. A rule is a pair of `due(court)` and `apply(court)`; a rule about one robot also
/// takes its index.
struct Court {
  const field::Rules& rules;
  const field::Field& field;
  const BallModel& ball_model;
  const ContactModel& contact;
  World& world;
  Book& book;
  GameCounts& counts;
  Events& events;
};

/// [ticks] between two checks of the robots: five times a second, as contacts are counted.
inline constexpr Tick kLook = kPushingUnit;

/// Returns the time since phase or set play last changed [ticks].
inline Tick in_phase(const Court& court) { return court.world.tick - court.book.phase_since; }

inline bool on_field(const Court& court, int robot) { return on_field(court.world.bodies[robot]); }

/// Returns how far a point lies ahead of the centre for a side [m]: > 0 in the opponents' half.
inline float ahead(const Court& court, Side side, Vec2 point) { return attack_sign(court.world, side) * point.x; }

/// Returns the |x| beyond which the whole ball is over a goal line [m]. Lines belong to the field, so their outer edge
/// counts.
inline float ball_over_goal_line(const Court& court) {
  return court.field.length / 2 + court.field.line_width / 2 + court.ball_model.radius;
}
/// Returns the |y| beyond which the whole ball is over a touch line [m].
inline float ball_over_touch_line(const Court& court) {
  return court.field.width / 2 + court.field.line_width / 2 + court.ball_model.radius;
}

/// Reports an event. `robot` is an index, or kNobody when the event is not about one robot.
void report(Court& court, Event::Kind kind, Side side, int robot, Vec2 at);

/// Puts the ball down at rest [m, field]. It counts as untouched since.
void place_ball(Court& court, Vec2 at);

/// Begins a new phase now. The robots receive it at once.
void begin_phase(Court& court, Phase phase);

/// Begins READY for the kick-off of `kicking`. The robots receive it at the tick `told`.
void begin_kick_off(Court& court, Side kicking, Tick told);

/// Places the ball for a set play of `kicking`. Play goes on.
void begin_set_play(Court& court, SetPlay set_play, Event::Kind kind, Side kicking, Vec2 at);

/// Ends the game.
void finish(Court& court);

/// Puts a robot down, standing and looking straight ahead. `facing` is the unit vector at `heading` [rad].
void put_robot(Court& court, int robot, Vec2 at, Vec2 facing, float heading);

/// Puts a robot at its own place on the touch line of its own half, facing across the field.
/// `line` +1 is the touch line at y > 0, -1 the other one.
void put_at_touch_line(Court& court, int robot, float line);

/// Returns the touch line nearer to a robot, +1 or -1. A robot exactly in the middle gets the one it faces.
float touch_line_of(const Body& body);

/// Takes a robot off the field for the offence `kind`, until its penalty is over.
void remove_robot(Court& court, int robot, Event::Kind kind);

}  // namespace sim::referee
