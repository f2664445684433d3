#include "sim/match/step.h"

#include <cmath>

#include "sim/match/pace.h"
#include "sim/motion/motion.h"
#include "sim/perception/perception.h"
#include "sim/referee/referee.h"
#include "sim/world/contact.h"

namespace sim {
namespace {

using Doing = Body::Doing;

bool on_field(const World& world, int robot) { return world.bodies[robot].doing != Doing::removed; }

/// Of this tick: it has decided and will move.
bool has_turn(const Robot& robot) { return robot.rest == robot.lag; }

const Team& team_of(const Params& params, int robot) { return params.teams[static_cast<int>(side_of(robot))]; }

/// Ball and contacts are the home side's.
const Models& common(const Params& params) { return params.teams[0].models; }

perception::Means perceiving(const Params& params, int robot) {
  const Models& own = team_of(params, robot).models;
  return {own.perception, own.effects, params.rules.field, params.marks, common(params).contact, common(params).ball};
}

motion::Means moving(const Params& params, int robot) {
  const Models& own = team_of(params, robot).models;
  return {own.motion, own.effects, common(params).ball};
}

referee::Means judging(const Params& params) { return {params.rules, common(params).ball, common(params).contact}; }

/// Beliefs from the world, a command from the beliefs, and when it is its turn again.
void think(const Params& params, State& state, int robot, agent::Trace* trace) {
  Robot& self = state.robots[robot];
  const Team& team = team_of(params, robot);
  perception::perceive(perceiving(params, robot), state.world, robot, self.lag, self.beliefs, self.cognition);
  const agent::Game game = referee::game_for(params.rules, state.world, state.book, robot);
  self.command = team.behaviour->decide({&params.rules.field, &team.models.motion}, game, self.beliefs,
                                        state.world.tick, self.mind, trace);
  self.rest = self.lag = static_cast<std::uint8_t>(ticks_to_next_turn(params, state, robot));
}

/// [s] of the game that are still to be played.
float remaining(const Params& params, const referee::Book& book) {
  const float halves = static_cast<float>(params.rules.halves - book.half + 1);
  return halves * params.rules.half_duration - static_cast<float>(book.clock) * kTickDuration;
}

/// To the teammates that hear it; and from now on the sender waits until it may send again.
void deliver(const Params& params, State& state, int sender) {
  const Models& models = team_of(params, sender).models;
  const Side side = side_of(sender);
  const std::uint32_t deaf = perception::deaf_players(models.perception, models.effects, state.world, sender);
  perception::Cognition& cognition = state.robots[sender].cognition;
  for (int player = 1; player <= state.world.players; ++player) {
    const int receiver = robot_of(side, player);
    if (receiver == sender || (deaf >> player & 1) != 0) continue;
    perception::receive(cognition.packet, sender, receiver, state.robots[receiver].beliefs);
  }
  cognition.on_air = false;
  cognition.radio_due =
      perception::next_packet(params.rules, models.effects, cognition.packet.sent,
                              state.book.packets[static_cast<int>(side)], remaining(params, state.book));
}

/// What is on its way arrives; whoever had his turn, or waits beside the field, may send anew.
void talk(const Params& params, State& state, int robot) {
  const Tick now = state.world.tick;
  Robot& self = state.robots[robot];
  perception::Cognition& cognition = self.cognition;
  if (now < cognition.radio_due) return;
  if (cognition.on_air) deliver(params, state, robot);

  const bool penalised = !on_field(state.world, robot);
  if ((!has_turn(self) && !penalised) || now < cognition.radio_due) return;

  const Models& models = team_of(params, robot).models;
  ++state.book.packets[static_cast<int>(side_of(robot))];
  cognition.packet = perception::packet_of(self.beliefs, self.mind, penalised, now);
  cognition.on_air = true;
  cognition.radio_due = now + perception::delay_of(models.perception, models.effects, state.world, robot);
  if (cognition.radio_due == now) deliver(params, state, robot);
}

/// Everybody who has his turn moves, up to his next.
void move_all(const Params& params, State& state) {
  World& world = state.world;
  world.touched = world.kicked = world.whiffed = kNobody;
  for_each_robot(world.players, [&](int robot) {
    const Robot& self = state.robots[robot];
    if (on_field(world, robot) && has_turn(self))
      motion::move(moving(params, robot), self.command, robot, self.lag, world);
  });
}

/// The referee's decisions, and what follows from them for what robots know.
void judge(const Params& params, State& state, referee::Events& events) {
  bool was_away[kMaxRobots];
  for (int robot = 0; robot < kMaxRobots; ++robot) was_away[robot] = !on_field(state.world, robot);
  const float attacked = state.world.home_attacks;

  referee::judge(judging(params), state.world, state.book, state.tally, events);

  // whoever comes onto the field begins anew; after half time that is everybody
  const bool changed_ends = state.world.home_attacks != attacked;
  for_each_robot(state.world.players, [&](int robot) {
    if (on_field(state.world, robot) && (was_away[robot] || changed_ends)) enter(params, state, robot);
  });
}

}  // namespace

void enter(const Params& params, State& state, int robot) {
  Robot& self = state.robots[robot];
  self = {};
  // a robot in a mirror begins to search the other way
  const float sign = attack_sign(state.world, side_of(robot));
  self.mind.search_side = std::copysign(1.f, sign * state.world.bodies[robot].position.y);
  perception::enter(perceiving(params, robot), state.world, robot, self.beliefs, self.cognition);
}

State begin(const Params& params, RandomKey key, referee::Events& events) {
  State state;
  events.count = 0;
  state.world.key = key;
  state.world.players = params.rules.players;
  referee::open(judging(params), state.world, state.book, events);
  for_each_robot(state.world.players, [&](int robot) { enter(params, state, robot); });
  return state;
}

void step(const Params& params, State& state, referee::Events& events, int traced, agent::Trace* trace) {
  World& world = state.world;
  events.count = 0;

  // everybody whose turn it is perceives and decides on the same world: nobody has moved yet
  for_each_robot(world.players, [&](int robot) {
    if (on_field(world, robot) && state.robots[robot].rest == 0)
      think(params, state, robot, traced == kEverybody ? trace + robot : traced == robot ? trace : nullptr);
  });
  for_each_robot(world.players, [&](int robot) { talk(params, state, robot); });

  // bodies and ball move on by a tick
  move_all(params, state);
  keep_bodies_apart(params.rules.field, common(params).contact, world);
  if (common(params).effects.official) walk_official(params.rules.field, world);
  roll(world.ball, common(params).ball.deceleration, common(params).ball.stop_speed, kTickDuration);
  bounce_ball(params.rules.field, common(params).ball, common(params).contact, common(params).effects, world);

  judge(params, state, events);
  for_each_robot(world.players, [&](int robot) {
    Robot& self = state.robots[robot];
    if (self.rest > 0) --self.rest;
    if (state.book.phase == agent::Game::Phase::playing && on_field(world, robot) && self.beliefs.ball.visible)
      ++state.tally.seen[robot];
  });
  ++world.tick;
}

bool finished(const State& state) { return state.book.phase == agent::Game::Phase::finished; }

}  // namespace sim
