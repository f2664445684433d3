// What every rule works on, and what several rules do.
#pragma once

#include <cmath>

#include "sim/referee/referee.h"

namespace sim::referee {

using Phase = agent::Game::Phase;
using SetPlay = agent::Game::SetPlay;
using Doing = Body::Doing;

/// One tick as the referee sees it. Rules are pairs of `due(court)` and `apply(court)`, those about one robot take its
/// index too.
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

/// Robots are looked at five times a second, as contacts are counted.
inline constexpr Tick kLook = 6;

/// [ticks] since phase or set play last changed.
inline Tick in_phase(const Court& court) { return court.world.tick - court.book.phase_since; }

inline bool on_field(const Court& court, int robot) { return court.world.bodies[robot].doing != Doing::removed; }

/// [m] how far a point lies ahead of the centre for a side: > 0 in the opponents' half.
inline float ahead(const Court& court, Side side, Vec2 point) { return attack_sign(court.world, side) * point.x; }

/// [m] |x| beyond which the ball is wholly over a goal line; lines belong to the field, so it is their outer edge.
inline float ball_over_goal_line(const Court& court) {
  return court.field.length / 2 + court.field.line_width / 2 + court.ball_model.radius;
}
/// [m] likewise |y| and the touch lines.
inline float ball_over_touch_line(const Court& court) {
  return court.field.width / 2 + court.field.line_width / 2 + court.ball_model.radius;
}

/// Writes an event down; `robot` kNobody: about none.
void tell(Court& court, Event::Kind kind, Side side, int robot, Vec2 at);

/// Puts the ball down at rest, [m, field]; nobody has touched it since.
void place_ball(Court& court, Vec2 at);

/// A new phase begins now and robots are told at once.
void begin_phase(Court& court, Phase phase);

/// Ready for the kick-off of `kicking`; robots hear of it at the tick `told`.
void begin_kick_off(Court& court, Side kicking, Tick told);

/// The ball is placed for a set play of `kicking`, play goes on.
void begin_set_play(Court& court, SetPlay set_play, Event::Kind kind, Side kicking, Vec2 at);

/// The game is over.
void finish(Court& court);

/// Puts a robot down, standing and looking straight on; `facing` is a unit vector at `heading` [rad].
void put_robot(Court& court, int robot, Vec2 at, Vec2 facing, float heading);

/// Puts a robot at its own place on the touch line of its own half, looking across the field.
/// `line` +1: the touch line at y > 0, -1: the other.
void put_at_touch_line(Court& court, int robot, float line);

/// The touch line [+1, -1] on whose side a robot is; of one exactly between them, the one it looks at.
float touch_line_of(const Body& body);

/// Takes a robot off the field for the offence `kind`, until its time is up.
void remove_robot(Court& court, int robot, Event::Kind kind);

}  // namespace sim::referee
