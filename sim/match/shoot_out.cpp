#include "sim/match/shoot_out.h"

#include "sim/match/play.h"
#include "sim/match/situation.h"

namespace sim {
namespace {

constexpr int kAttacker = 2, kKeeper = 1;  // players
constexpr float kKnown = 0.05f;            // [m] deviation of the ball that both robots have seen in SET
constexpr float kWaiting = 1;              // [m] from the edge of the carpet to the other robots

/// Puts a robot down at (x, 0), facing along x or against it.
void stand(World& world, int robot, float x, float facing) {
  Body& body = world.bodies[robot];
  body = Body{};
  body.position = {x, 0};
  body.facing = {facing, 0};
  body.heading = facing > 0 ? 0 : kPi;
}

/// Returns the key of a shot; a shoot-out of another game has other keys.
RandomKey key_of_shot(RandomKey key, std::size_t number) {
  const auto words = draw(key, kNobody, Draw::kick_off, static_cast<std::uint32_t>(number) + 2);
  return {.seed = std::uint64_t{words[0]} << 32 | words[1]};
}

}  // namespace

const char* name_of(PenaltyShot::End end) {
  static constexpr const char* kNames[] = {"goal", "out", "time up"};
  return kNames[static_cast<int>(end)];
}

State penalty_shot(const Params& params, RandomKey key, Side side) {
  referee::Events events;
  State state = begin(params, key, events);
  World& world = state.world;
  const float attack = attack_sign(world, side), goal_line = attack * params.rules.field.length / 2;
  const float mark = goal_line - attack * params.rules.field.penalty_mark;
  const int attacker = robot_of(side, kAttacker), keeper = robot_of(other(side), kKeeper);

  place(world.ball, {mark, 0});
  stand(world, attacker, mark - attack * kShotRun, attack);
  stand(world, keeper, goal_line, -attack);
  for_each_robot(world.players, [&](int robot) {
    if (robot == attacker || robot == keeper) return;
    Body& body = world.bodies[robot];
    const float line = body.position.y < 0 ? -1.f : 1.f;
    body.position.y = line * (params.rules.field.width / 2 + params.rules.field.border + kWaiting);
    body.doing = Body::Doing::removed;
    state.book.penalised_until[robot] = kNever;
  });
  state.book.kicking = state.book.last_touch = side;
  start_play(params, state);
  know_ball(state, world.tick, kKnown);
  return state;
}

PenaltyShot play_shot(const Params& params, RandomKey key, Side side) {
  PenaltyShot shot{.side = side, .end = PenaltyShot::End::time_up, .ticks = 0};
  State state = penalty_shot(params, key, side);
  const Tick end = state.world.tick + ticks(params.rules.shoot_out_duration);
  bool over = false;
  shot.ticks = play(
      params, state, [&](const State& now) { return over || now.world.tick >= end; },
      [&](const referee::Event& event) {
        const bool goal = event.kind == referee::Event::Kind::goal;
        if (over || !(goal || referee::is_out(event.kind))) return;
        over = true;
        shot.end = goal && event.side == side ? PenaltyShot::End::goal : PenaltyShot::End::out;
      });
  return shot;
}

ShootOut play_shoot_out(const Params& params, RandomKey key) {
  ShootOut shoot_out;
  referee::shoot_out::Tally& tally = shoot_out.tally;
  tally.first = uniform(draw(key, kNobody, Draw::kick_off, 1)[0]) < 0.5f ? Side::home : Side::away;
  while (const auto side = referee::shoot_out::next(params.rules, tally)) {
    const PenaltyShot shot = play_shot(params, key_of_shot(key, shoot_out.shots.size()), *side);
    ++tally.shots[static_cast<int>(*side)];
    tally.goals[static_cast<int>(*side)] += shot.end == PenaltyShot::End::goal;
    shoot_out.shots.push_back(shot);
  }
  return shoot_out;
}

}  // namespace sim
