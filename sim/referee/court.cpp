#include "sim/referee/court.h"

namespace sim::referee {
namespace {

constexpr float kWaiting = 1;  // [m] from the edge of the carpet to the waiting removed robots

/// Returns how far behind the halfway line a player's own place on the touch line is [m]. Players 1.. stand at
/// equal distances from the own goal line to the halfway line.
float own_place(const field::Rules& rules, int player) {
  return rules.field.length / 2 * static_cast<float>(rules.players + 1 - player) /
         static_cast<float>(rules.players + 1);
}

}  // namespace

void report(Court& court, Event::Kind kind, Side side, int robot, Vec2 at) {
  court.events.add({.kind = kind,
                    .side = side,
                    .robot = static_cast<std::uint8_t>(robot),
                    .tick = court.world.tick,
                    .at = at,
                    .set_play = court.book.set_play});
}

void place_ball(Court& court, Vec2 at) {
  place(court.world.ball, at);

  Book& book = court.book;
  book.last_toucher = kNobody;
  book.kick_off_by = kNobody;
  book.last_touch_tick = court.world.tick;
  book.last_touch_at = at;
  book.ball_before = at;
  book.stuck_at = at;
  book.stuck_since = court.world.tick;
}

void begin_phase(Court& court, Phase phase) {
  court.book.phase = phase;
  court.book.phase_since = court.world.tick;
  court.book.told_phase_since = court.world.tick;
}

void begin_kick_off(Court& court, Side kicking, Tick told) {
  Book& book = court.book;
  book.playing_since = book.phase_since;
  begin_phase(court, Phase::ready);
  book.told_phase_since = told;
  book.still_since = told;
  book.set_play = SetPlay::kick_off;
  book.kicking = kicking;
  book.last_touch = kicking;
  book.ball_free = false;
  // the ball stays there until the robots know: they may still be after it
  place_ball(court, court.world.ball.position);
  report(court, Event::Kind::ready, kicking, kNobody, {});
}

void begin_set_play(Court& court, SetPlay set_play, Event::Kind kind, Side kicking, Vec2 at) {
  Book& book = court.book;
  begin_phase(court, Phase::playing);
  book.set_play = set_play;
  book.kicking = kicking;
  book.last_touch = kicking;
  book.ball_free = false;
  place_ball(court, at);
  report(court, kind, kicking, kNobody, at);
}

void finish(Court& court) {
  begin_phase(court, Phase::finished);
  court.book.set_play = SetPlay::none;
  report(court, Event::Kind::end, Side::home, kNobody, court.world.ball.position);
}

void put_robot(Court& court, int robot, Vec2 at, Vec2 facing, float heading) {
  Body& body = court.world.bodies[robot];
  const float walked = body.walked;
  body = Body{};
  body.position = at;
  body.facing = facing;
  body.heading = heading;
  body.since = court.world.tick;
  body.walked = walked;
  court.world.crowded = true;
}

void put_at_touch_line(Court& court, int robot, float line) {
  const float own_half = -attack_sign(court.world, side_of(robot));
  const Vec2 at{own_half * own_place(court.rules, player_of(robot)), line * court.field.width / 2};
  put_robot(court, robot, at, {0, -line}, -line * kPi / 2);
}

float touch_line_of(const Body& body) {
  const float side = body.position.y != 0 ? body.position.y : body.facing.y;
  return side < 0 ? -1.f : 1.f;
}

void remove_robot(Court& court, int robot, Event::Kind kind) {
  const Side side = side_of(robot);
  Body& body = court.world.bodies[robot];
  report(court, kind, side, robot, body.position);

  // each earlier penalty of the team makes this one longer
  std::uint16_t& penalties = court.book.penalties[static_cast<int>(side)];
  const float seconds = court.rules.penalty_duration + court.rules.penalty_step * static_cast<float>(penalties);
  court.book.penalised_until[robot] = court.world.tick + ticks(seconds);
  ++penalties;

  // the robot is carried off over the nearer touch line
  const float line = touch_line_of(body);
  put_at_touch_line(court, robot, line);
  body.position.y += line * (court.field.border + kWaiting);
  body.doing = Doing::removed;
}

}  // namespace sim::referee
