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

const Team& team_of(const Params& params, int robot) { return params.teams[static_cast<int>(side_of(robot))]; }

/// Ball and contacts are the home side's.
const Models& common(const Params& params) { return params.teams[0].models; }

/// What the robots of a side sense, decide and move with.
struct Means {
  const Team& team;
  perception::Means perceiving;
  motion::Means moving;
  agent::Surroundings surroundings;
};

Means means_of(const Params& params, Side side) {
  const Team& team = params.teams[static_cast<int>(side)];
  const Models& own = team.models;
  const BallModel& ball = common(params).ball;
  return {team,
          {own.perception, own.effects, params.rules.field, params.marks, common(params).contact, ball},
          {own.motion, own.effects, ball},
          {&params.rules.field, &own.motion}};
}

referee::Means judging(const Params& params) { return {params.rules, common(params).ball, common(params).contact}; }

/// Some of the robots.
struct Some {
  int count = 0;
  std::uint8_t robots[kMaxRobots];

  void add(int robot) { robots[count++] = static_cast<std::uint8_t>(robot); }
};

/// What there is to do in a tick.
struct Due {
  Some turns;   // of robots on the field
  Some radios;  // something arrives, or may be sent
};

/// Everybody else rests.
Due due_in(State& state) {
  Due due;
  for_each_robot(state.world.players, [&](int robot) {
    Robot& self = state.robots[robot];
    if (self.rest > 0)
      --self.rest;
    else if (on_field(state.world, robot))
      due.turns.add(robot);
    if (self.cognition.radio_due <= state.world.tick) due.radios.add(robot);
  });
  return due;
}

/// Beliefs from the world, a command from the beliefs, and when it is its turn again.
void think(const Params& params, const Means& means, State& state, int robot, agent::Trace* trace) {
  Robot& self = state.robots[robot];
  perception::perceive(means.perceiving, state.world, robot, self.lag, self.beliefs, self.cognition);
  const agent::Game game = referee::game_for(params.rules, state.world, state.book, robot);
  self.command =
      means.team.behaviour->decide(means.surroundings, game, self.beliefs, state.world.tick, self.mind, trace);
  self.lag = static_cast<std::uint8_t>(ticks_to_next_turn(params, state, robot));
  self.rest = static_cast<std::uint8_t>(self.lag - 1);
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

void send(const Params& params, State& state, int robot) {
  Robot& self = state.robots[robot];
  const Tick now = state.world.tick;
  const Models& models = team_of(params, robot).models;
  ++state.book.packets[static_cast<int>(side_of(robot))];
  self.cognition.packet = perception::packet_of(self.beliefs, self.mind, !on_field(state.world, robot), now);
  self.cognition.on_air = true;
  self.cognition.radio_due = now + perception::delay_of(models.perception, models.effects, state.world, robot);
}

/// What is on its way arrives; then the robot may send, if it is its turn or it waits beside the field. What comes
/// without delay arrives at once.
void talk(const Params& params, State& state, int robot) {
  const Robot& self = state.robots[robot];
  const auto is_due = [&] { return self.cognition.radio_due <= state.world.tick; };
  if (self.cognition.on_air) deliver(params, state, robot);
  const bool has_turn = self.rest + 1 == self.lag;
  if (!is_due() || (!has_turn && on_field(state.world, robot))) return;
  send(params, state, robot);
  if (is_due()) deliver(params, state, robot);
}

/// The referee's decisions; whoever comes onto the field begins anew, after half time that is everybody.
void judge(const Params& params, State& state, referee::Events& events) {
  referee::judge(judging(params), state.world, state.book, state.tally, events);
  for (int i = 0; i < events.count; ++i) {
    const referee::Event& event = events.list[static_cast<std::size_t>(i)];
    if (event.kind == referee::Event::Kind::returned) enter(params, state, event.robot);
    if (event.kind == referee::Event::Kind::half_time)
      for_each_robot(state.world.players, [&](int robot) { enter(params, state, robot); });
  }
}

void count_sights(State& state) {
  for_each_robot(state.world.players, [&](int robot) {
    state.tally.seen[robot] += state.robots[robot].beliefs.ball.visible && on_field(state.world, robot);
  });
}

}  // namespace

void enter(const Params& params, State& state, int robot) {
  Robot& self = state.robots[robot];
  self = {};
  // a robot in a mirror begins to search the other way
  const float sign = attack_sign(state.world, side_of(robot));
  self.mind.search_side = std::copysign(1.f, sign * state.world.bodies[robot].position.y);
  perception::enter(means_of(params, side_of(robot)).perceiving, state.world, robot, self.beliefs, self.cognition);
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
  const Means means[] = {means_of(params, Side::home), means_of(params, Side::away)};
  const auto means_for = [&](int robot) -> const Means& { return means[static_cast<int>(side_of(robot))]; };

  // everybody whose turn it is perceives and decides on the same world: nobody has moved yet
  const Due due = due_in(state);
  for (int i = 0; i < due.turns.count; ++i) {
    const int robot = due.turns.robots[i];
    think(params, means_for(robot), state, robot,
          traced == kEverybody ? trace + robot
          : traced == robot    ? trace
                               : nullptr);
  }
  for (int i = 0; i < due.radios.count; ++i) talk(params, state, due.radios.robots[i]);

  // bodies move up to their next turn, contacts and ball by a tick
  world.touched = world.kicked = world.whiffed = kNobody;
  for (int i = 0; i < due.turns.count; ++i) {
    const int robot = due.turns.robots[i];
    motion::move(means_for(robot).moving, state.robots[robot].command, robot, state.robots[robot].lag, world);
  }
  Crowd crowd = crowd_of(world);
  keep_bodies_apart(params.rules.field, common(params).contact, crowd, world);
  if (common(params).effects.official) walk_official(params.rules.field, world);
  roll(world.ball, common(params).ball.deceleration, common(params).ball.stop_speed, kTickDuration);
  bounce_ball(params.rules.field, common(params).ball, common(params).contact, common(params).effects, crowd, world);

  judge(params, state, events);
  if (referee::in_play(state.book)) count_sights(state);
  ++world.tick;
}

bool finished(const State& state) { return state.book.phase == agent::Game::Phase::finished; }

}  // namespace sim
