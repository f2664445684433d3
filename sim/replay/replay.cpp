#include "sim/replay/replay.h"

#include "sim/match/situation.h"
#include "sim/match/step.h"
#include "sim/math/angles.h"

namespace sim::replay {
namespace {

using Doing = Body::Doing;

constexpr float kKnownDeviation = 0.1f;  // [m] and [m/s] of a ball just seen

void put(Body& body, const Place& place) {
  body.position = place.position;
  body.heading = normalized(place.heading);
  body.facing = direction(body.heading);
}

}  // namespace

State Replay::begin(const Params& params, RandomKey key) {
  referee::Events events;
  State state = sim::begin(params, key, events);
  state.book.half = static_cast<std::uint8_t>(recording_.half);
  state.world.home_attacks = recording_.half % 2 == 1 ? 1.f : -1.f;
  for_each_robot(state.world.players, [&](int robot) {
    Body& body = state.world.bodies[robot];
    if (const auto place = recording_.robots[static_cast<std::size_t>(robot)].at(from_)) {
      put(body, *place);
    } else {
      body.doing = Doing::removed;
      state.book.penalised_until[robot] = kNever;
    }
  });
  place_ball(state);
  start_play(params, state);
  place(params, state);
  know_ball(state, state.world.tick, kKnownDeviation);
  return state;
}

void Replay::place(const Params& params, State& state) {
  for_each_robot(state.world.players, [&](int robot) {
    if (is_recorded(robot)) place_robot(params, state, robot);
  });
  if (recorded_[0] && recorded_[1]) place_ball(state);
  state.world.crowded = true;  // bodies have moved
}

void Replay::place_robot(const Params& params, State& state, int robot) {
  Body& body = state.world.bodies[robot];
  const Track& track = recording_.robots[static_cast<std::size_t>(robot)];
  const std::optional<Place> place = track.at(from_ + state.world.tick);
  Missing& missing = missing_[static_cast<std::size_t>(robot)];
  if (!place) {
    if (!track.empty()) ++missing.absent;
    body.doing = Doing::removed;
    state.book.penalised_until[robot] = kNever;
    return;
  }
  if (place->held) ++missing.held;
  const bool enters = !on_field(body);
  put(body, *place);
  body.velocity = {}, body.turn_rate = 0;
  body.doing = place->fallen ? Doing::fallen : Doing::standing;
  body.since = state.world.tick;
  body.touching = body.pushing = 0;
  state.book.penalised_until[robot] = 0;
  if (enters) enter(params, state, robot);
}

void Replay::place_ball(State& state) const {
  const Tick now = from_ + state.world.tick;
  const std::optional<Place> ball = recording_.ball.at(now);
  if (!ball) return;
  sim::place(state.world.ball, ball->position);
  state.world.ball.velocity = recording_.ball.velocity_at(now);
}

}  // namespace sim::replay
