#include "sim/motion/walk.h"

#include <algorithm>
#include <cmath>

#include "sim/motion/batch.h"
#include "sim/motion/rhythm.h"
#include "sim/motion/walk_lanes.h"

namespace sim::motion {
namespace {

bool wants_to_walk(const Command& command, const Errand& errand) {
  switch (command.body) {
    case Command::Body::walk_speed: return errand.walk.x != 0 || errand.walk.y != 0 || errand.turn != 0;
    case Command::Body::walk_to:
      return squared_length(errand.walk) > kArrived * kArrived || std::abs(errand.turn) > kArrivedTurn;
    default: return false;
  }
}

float seconds(Tick ticks) { return static_cast<float>(ticks) * kTickDuration; }

/// The legs of robots with the same model.
struct Legs {
  const Walk& walk;
  const Effects& effects;
  Rhythm rhythm;
};

/// Changes between standing, starting, walking and stopping. Returns false when the body does not move yet.
bool change_gear(const Walk& walk, const Effects& effects, bool wanted, Tick now, Body& body) {
  using Doing = Body::Doing;
  const auto shift = [&](Doing doing) { body.doing = doing, body.since = now; };
  if (wanted) {
    if (body.doing == Doing::walking) return true;
    if (body.doing == Doing::standing) shift(effects.walk_delay ? Doing::starting : Doing::walking);
    if (body.doing == Doing::stopping) shift(Doing::walking);
    if (body.doing == Doing::starting && now - body.since >= ticks(walk.start_delay)) shift(Doing::walking);
    return body.doing == Doing::walking;
  }
  if (body.doing == Doing::starting) shift(Doing::standing);
  if (body.doing == Doing::walking) shift(Doing::stopping);
  const bool still = body.velocity == Vec2{} && body.turn_rate == 0;
  const Tick delay = effects.walk_delay ? ticks(walk.stop_delay) : 0;
  if (body.doing == Doing::stopping && (still || !effects.walk_acceleration) && now - body.since >= delay) {
    body.velocity = {};
    body.turn_rate = 0;
    shift(Doing::standing);
  }
  return body.doing == Doing::stopping;
}

/// Returns the time until a stopping body may stand [ticks], at least 1.
Tick until_standing(const Walk& walk, Tick now, const Body& body) {
  const Tick end = body.since + ticks(walk.stop_delay);
  return end > now ? end - now : 1;
}

/// Returns the time until a stopping body is still and its step ends [ticks], at least 1.
Tick until_still(const Walk& walk, bool limited, const Body& body) {
  if (!limited) return 1;
  const float seconds =
      std::max(length(body.velocity) / walk.acceleration, std::abs(body.turn_rate) / walk.turn_acceleration);
  return std::max<Tick>(1, static_cast<Tick>(std::ceil((1 - kRounding) * seconds * kTicksPerSecond)));
}

/// A part of a walk within which nothing changes but speed and place.
struct Piece {
  Tick ticks = 0;       // 0: the walk is over
  Tick until_next = 0;  // [ticks] from its begin to the next step
  bool begins = false;  // begins a step, or walks within one that has begun
};

/// Returns the next piece. Waits for the end of a start delay, if there is one.
Piece next_piece(const Legs& legs, Walker& walker) {
  Body& body = walker.body();
  const bool begins = !in_step(legs.rhythm, body, walker.now);
  while (begins) {
    const bool wanted = wants_to_walk(*walker.command, walker.errand);
    if (change_gear(legs.walk, legs.effects, wanted, walker.now, body)) break;
    if (!wanted) return {};
    const Tick delay = body.since + ticks(legs.walk.start_delay) - walker.now;
    if (walker.left <= delay) return {};
    walker.now += delay, walker.left -= delay;
  }

  const Tick until_next = legs.rhythm.until_next(walker.now);
  Tick together = std::min(walker.left, until_next);
  if (body.doing == Body::Doing::stopping)
    together = std::min({together, until_standing(legs.walk, walker.now, body),
                         until_still(legs.walk, legs.effects.walk_acceleration, body)});
  return {together, until_next, begins};
}

float gain_of(const Command& command) { return clamped(command.gain, 0, 1); }

/// Returns the walk of this robot: the speeds of the model times its own pace, which is the same in the whole game.
Walk walk_of(const Legs& legs, const Walker& walker) {
  if (!legs.effects.walk_spread) return legs.walk;
  return walk_at(legs.walk, share_of(legs.walk, draw(walker.world->key, static_cast<std::uint32_t>(walker.robot),
                                                     Draw::walk_pace, 0)));
}

Luck luck_of(const Legs& legs, const Walker& walker) {
  if (!legs.effects.walk_noise) return {};
  return luck_of(legs.walk, draw(walker.world->key, static_cast<std::uint32_t>(walker.robot), Draw::walk_noise,
                                 legs.rhythm.step_at(walker.now)));
}

/// Settles the gait of the step that begins now, or of the present step when the body begins to walk within it. Also
/// removes the rounding of the small turns before. Not inline, because it is rare.
[[gnu::noinline]] void begin_step(const Legs& legs, const Walker& walker, const Piece& piece) {
  Body& body = walker.body();
  body.facing = direction(body.heading);
  Gait gait;
  if (body.doing == Body::Doing::walking)
    gait = gait_of(walk_of(legs, walker), legs.effects.walk_acceleration, gain_of(*walker.command), walker.errand,
                   seconds(piece.until_next), luck_of(legs, walker));
  body.step_velocity = gait.velocity;
  body.step_turn_rate = gait.turn_rate;
}

Walking walking(const Body& body) {
  return {body.position, body.heading, body.facing, body.velocity, body.turn_rate, body.walked};
}

void take(const Walking& walking, Body& body) {
  body.position = walking.position, body.heading = walking.heading, body.facing = walking.facing;
  body.velocity = walking.velocity, body.turn_rate = walking.turn_rate, body.walked = walking.walked;
}

/// Walks with one robot to the end, piece by piece.
[[gnu::flatten]] void walk_on(const Legs& legs, Walker& walker) {
  Body& body = walker.body();
  while (true) {
    const Piece piece = next_piece(legs, walker);
    if (piece.ticks == 0) return;
    if (piece.begins) begin_step(legs, walker, piece);
    const Gait gait{body.step_velocity, body.step_turn_rate};
    const Glide glided = glide(legs.walk, legs.effects.walk_acceleration, gait, seconds(piece.ticks), walking(body));
    take(glided.body, body);
    walker.now += piece.ticks, walker.left -= piece.ticks;
    if (walker.left == 0) return;
    walker.errand = after(walker.errand, glided.moved);
  }
}

void gather(const Walker& walker, int i, WalkLanes& lanes) {
  const Body& body = walker.body();
  lanes.set_body(i, walking(body));
  lanes.gait.set(i, {body.step_velocity, body.step_turn_rate});
  lanes.set_errand(i, walker.errand);
  lanes.gain[i] = gain_of(*walker.command);
}

void scatter(const WalkLanes& lanes, int i, const Walker& walker) {
  Body& body = walker.body();
  take(lanes.body(i), body);
  const Gait gait = lanes.gait[i];
  body.step_velocity = gait.velocity, body.step_turn_rate = gait.turn_rate;
}

template <bool Limited>
[[gnu::noinline]] void move_lanes(const Legs& legs, bool begin, WalkLanes& lanes) {
  if (begin) in_lanes<begin_steps<Limited>>(legs.walk, legs.effects, lanes);
  in_lanes<glide_on<Limited>>(legs.walk, lanes);
}

/// Reads the next piece of a walk into lane `i`. Returns its ticks.
Tick begin_piece(const Legs& legs, Walker& walker, int i, WalkLanes& lanes) {
  const Piece piece = next_piece(legs, walker);
  lanes.draws.set(i, walker.world->key, walker.robot, legs.rhythm.step_at(walker.now));
  lanes.begins[i] = piece.begins ? 1 : 0;
  lanes.walks[i] = walker.body().doing == Body::Doing::walking ? 1 : 0;
  lanes.until_next[i] = seconds(piece.until_next);
  lanes.dt[i] = seconds(piece.ticks);
  return piece.ticks;
}

/// Walks with several robots through one piece each, in lanes. Keeps those that walk on, at the front, and returns their
/// number.
[[gnu::flatten]] std::size_t walk_piece(const Legs& legs, std::span<Walker> walkers) {
  WalkLanes lanes;
  if (walkers.size() < kLanes) lanes = {};
  Tick used[kLanes];
  int count = 0;
  bool begin = false;
  for (const Walker& next : walkers) {
    Walker& walker = walkers[static_cast<std::size_t>(count)] = next;
    used[count] = begin_piece(legs, walker, count, lanes);
    if (used[count] == 0) continue;
    gather(walker, count, lanes);
    begin |= lanes.begins[count] != 0;
    ++count;
  }
  legs.effects.walk_acceleration ? move_lanes<true>(legs, begin, lanes) : move_lanes<false>(legs, begin, lanes);

  std::size_t kept = 0;
  for (int i = 0; i < count; ++i) {
    Walker& walker = walkers[static_cast<std::size_t>(i)];
    scatter(lanes, i, walker);
    walker.now += used[i], walker.left -= used[i];
    if (walker.left > 0) {
      walker.errand = lanes.errand(i);
      walkers[kept++] = walker;
    }
  }
  return kept;
}

}  // namespace

void walk_alone(const MotionParams& params, Walker walker) {
  walk_on({params.model.walk, params.effects, Rhythm(params.model.walk)}, walker);
}

std::size_t walk_together(const MotionParams& params, std::span<Walker> walkers) {
  const Legs legs{params.model.walk, params.effects, Rhythm(params.model.walk)};
  if (worth_lanes(walkers.size())) return walk_piece(legs, walkers);
  for (Walker& walker : walkers) walk_on(legs, walker);
  return 0;
}

}  // namespace sim::motion
