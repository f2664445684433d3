#include "sim/match/step.h"

#include <algorithm>
#include <array>
#include <span>
#include <type_traits>

#include "sim/match/due.h"
#include "sim/match/pace.h"
#include "sim/motion/motion.h"
#include "sim/perception/perception.h"
#include "sim/referee/referee.h"
#include "sim/world/contact.h"

// Read this file from the bottom: `step_many` is one tick of many games, and each function above it is one part of that.
// All games perceive together, and move together: the robots that are due, of all games, fill the lanes.
//
//   step_many ─ act ──── perceive ── perception::perceive
//             │        ├ think ───── Behaviour::decide, wait_of
//             │        ├ talk ────── perception::transmit, perception::receive
//             │        └ move ────── motion::move
//             ├ meet ── keep_bodies_apart, topple, bounce_ball
//             └ judge ─ referee::judge
namespace sim {
namespace {

const Team& team_of(const Params& params, int robot) { return params.teams[static_cast<int>(side_of(robot))]; }

/// Returns the models of ball and contacts. Both sides share those of the home side.
const Models& common(const Params& params) { return params.teams[0].models; }

perception::PerceptionParams perception_params(const Params& params, const Models& own) {
  const Models& shared = common(params);
  return {own.perception, own.effects, params.rules.field, params.marks, shared.contact, shared.ball};
}

motion::MotionParams motion_params(const Params& params, const Models& own) {
  return {own.motion, own.effects, common(params).ball};
}

referee::RefereeParams referee_params(const Params& params) {
  return {params.rules, common(params).ball, common(params).contact};
}

/// The games of one call, and who is due in this tick.
struct Round {
  std::span<State* const> games;
  std::array<Due, kMostGames> due;  // by game
};

/// Notes the penalties of the teammates. The GameController sends them to all robots, and the robot's own team link
/// notes them likewise (robot/game/team_link.cpp). A mate that returns is active again with its next packet.
void hear_penalties(const State& state, int robot, agent::Beliefs& beliefs) {
  const Tick* const until = &state.book.penalised_until[robot_of(side_of(robot), 1)];
  Tick anybody = 0;
#pragma GCC unroll 7
  for (int mate = 0; mate < kMaxPlayers; ++mate) anybody |= until[mate];
  if (anybody == 0) return;
  for (int mate = 0; mate + 1 < state.world.players; ++mate)
    if (until[agent::player_of_mate(player_of(robot), mate) - 1] != 0) beliefs.mates[mate].active = false;
}

/// Calls pass(models, items) for those robots of all games that `Which` selects. make(state, robot) makes one item for each.
/// A call has at most kMostLooks items, all of robots with the same models.
template <Some Due::*Which, class Make, class Pass>
void in_batches(const Params& params, const Round& round, Make&& make, Pass&& pass) {
  using Item = std::invoke_result_t<Make, State&, int>;
  struct Batch {
    const Models* models = nullptr;
    std::size_t count = 0;
    std::array<Item, perception::kMostLooks> items;
  };
  Batch batches[2];  // by side
  const auto flush = [&](Batch& batch) {
    if (batch.count > 0) pass(*batch.models, std::span<const Item>{batch.items.data(), batch.count});
    batch.count = 0;
  };
  for (std::size_t i = 0; i < round.games.size(); ++i)
    for_each_of(round.due[i].*Which, [&](int robot) {
      const Models& models = models_of(params, robot);
      Batch& batch = batches[static_cast<int>(side_of(robot))];
      if (&models != batch.models || batch.count == batch.items.size()) flush(batch);
      batch.models = &models;
      batch.items[batch.count++] = make(*round.games[i], robot);
    });
  for (Batch& batch : batches) flush(batch);
}

/// Updates the beliefs from the world.
void perceive(const Params& params, const Round& round) {
  const auto look = [](State& state, int robot) {
    Robot& self = state.robots[robot];
    return perception::Look{&state.world, &self.beliefs, &self.cognition, robot, state.schedule.lag[robot]};
  };
  in_batches<&Due::turns>(params, round, look, [&](const Models& models, std::span<const perception::Look> looks) {
    perception::perceive(perception_params(params, models), looks);
  });
}

/// Decides a command from the beliefs, and schedules the robot's next turn.
void think(const Params& params, State& state, int robot, agent::Trace* trace) {
  Robot& self = state.robots[robot];
  const Tick now = state.world.tick, steps = state.schedule.lag[robot];
  if (referee::in_play(state.book) && self.beliefs.ball.visible) state.counts.seen[robot] += steps;
  hear_penalties(state, robot, self.beliefs);
  const agent::Surroundings surroundings{&params.rules, &models_of(params, robot).motion};
  const agent::Game game = referee::game_for(params.rules, state.world, state.book, robot);
  self.command = team_of(params, robot).behaviour->decide(surroundings, game, self.beliefs, now, self.mind, trace);
  const Wait wait = wait_of(params, state, robot);
  state.schedule.lag[robot] = static_cast<std::uint8_t>(wait.turn);
  state.world.bodies[robot].glide = static_cast<std::uint8_t>(wait.move);
  state.schedule.turn[robot] = now + wait.turn;
}

/// Moves the bodies on with their commands, at most up to their next turns. A head moves once, at the end of that time:
/// no image is taken before.
void move(const Params& params, const Round& round) {
  const auto mover = [](State& state, int robot) {
    const Robot& self = state.robots[robot];
    Body& body = state.world.bodies[robot];
    const Tick now = state.world.tick, left = state.schedule.turn[robot] - now;
    const Tick steps = std::min<Tick>(body.glide, left);
    body.moved = static_cast<std::uint8_t>(now + steps);
    const Tick head_steps = steps == left ? state.schedule.lag[robot] : 0u;
    return motion::Mover{&self.command, &self.cognition.last, &state.world, robot, steps, head_steps};
  };
  in_batches<&Due::moves>(params, round, mover, [&](const Models& models, std::span<const motion::Mover> movers) {
    motion::move(motion_params(params, models), movers);
  });
}

/// Returns the remaining time of the whole game [s].
float remaining(const Params& params, const referee::Book& book) {
  const float halves = static_cast<float>(params.rules.halves - book.half + 1);
  return halves * params.rules.half_duration - static_cast<float>(book.clock) * kTickDuration;
}

/// Delivers the sender's packet to the teammates that do not lose it, and schedules the sender's next packet.
void deliver(const Params& params, State& state, int sender) {
  const Side side = side_of(sender);
  perception::Cognition& cognition = state.robots[sender].cognition;
  for (int mate = 0; mate + 1 < state.world.players; ++mate) {
    if ((state.schedule.lost[sender] >> mate & 1) != 0) continue;
    const int receiver = robot_of(side, agent::player_of_mate(player_of(sender), mate));
    perception::receive(cognition.packet, sender, receiver, state.robots[receiver].beliefs);
  }
  cognition.on_air = false;
  state.schedule.radio[sender] =
      perception::next_packet(params.rules, models_of(params, sender).effects, cognition.packet.sent,
                              state.book.packets[static_cast<int>(side)], remaining(params, state.book));
}

/// Puts the sender's beliefs on the air as a packet, with its delay and its losses.
void send(const Params& params, State& state, int sender) {
  const Tick now = state.world.tick;
  const Models& models = models_of(params, sender);
  Robot& self = state.robots[sender];
  const auto transmission = perception::transmit(models.perception, models.effects, state.world, sender);
  self.cognition.packet = perception::packet_of(self.beliefs, self.mind, !on_field(state.world.bodies[sender]), now);
  self.cognition.on_air = true;
  state.schedule.lost[sender] = transmission.lost;
  state.schedule.radio[sender] = now + transmission.delay;
  ++state.book.packets[static_cast<int>(side_of(sender))];
}

/// Delivers the robot's packet if one is on the air. Then the robot may send the next one, right after its turn or
/// while it waits beside the field. A packet without delay is delivered at once.
void talk(const Params& params, State& state, int robot) {
  const Tick now = state.world.tick;
  const auto is_due = [&] { return state.schedule.radio[robot] <= now; };
  if (state.robots[robot].cognition.on_air) deliver(params, state, robot);
  const bool has_turn = state.schedule.turn[robot] == now + state.schedule.lag[robot];
  if (!is_due()) return;
  if (!has_turn && on_field(state.world.bodies[robot])) {
    state.schedule.radio[robot] = state.schedule.turn[robot];
    return;
  }
  send(params, state, robot);
  if (is_due()) deliver(params, state, robot);
}

/// Receives the decision traces of all robots, of one, or of none.
struct Tracing {
  int traced = -1;
  agent::Trace* traces = nullptr;

  agent::Trace* of(int robot) const {
    return traced == kEverybody ? traces + robot : traced == robot ? traces : nullptr;
  }
};

/// Lets the robots that are due perceive, decide, communicate and move.
void act(const Params& params, Round& round, const Tracing& tracing) {
  const auto& games = round.games;
  const auto is_due = [&](std::size_t i) { return games[i]->schedule.next <= games[i]->world.tick; };
  for (std::size_t i = 0; i < games.size(); ++i) round.due[i] = is_due(i) ? due_in(*games[i]) : Due{};

  // all robots that have a turn see the same world: no body has moved yet
  perceive(params, round);
  for (std::size_t i = 0; i < games.size(); ++i) {
    for_each_of(round.due[i].turns, [&](int robot) { think(params, *games[i], robot, tracing.of(robot)); });
    for_each_of(round.due[i].radios, [&](int robot) { talk(params, *games[i], robot); });
  }
  move(params, round);

  // until then `act` skips the game
  for (std::size_t i = 0; i < games.size(); ++i)
    if (is_due(i)) games[i]->schedule.next = next_tick(*games[i], round.due[i]);
}

bool falls_by_table(const Models& models) { return models.effects.falls && models.motion.falls.table.given; }

/// Lets robots fall that have run into each other.
void topple(const Params& params, World& world) {
  bool anybody = false;
  for_each_robot(world.players, [&](int robot) { anybody |= falls_by_table(models_of(params, robot)); });
  if (!anybody) return;
  const AllCollisions collisions = collisions_of(common(params).contact, world);
  for_each_robot(world.players, [&](int robot) {
    motion::topple(motion_params(params, models_of(params, robot)), collisions.closing[robot], robot, world);
  });
}

/// Rolls the ball and resolves contacts: robots with robots, the ball with robots and posts.
///
/// With no moving body and a resting ball there is nothing to resolve, except when the ball was touched in the last
/// tick: a robot may still squeeze it.
void meet(const Params& params, bool bodies_move, bool touched, World& world) {
  const auto& [name, effects, ball, contact, motion, perception] = common(params);
  const field::Field& field = params.rules.field;
  roll(world.ball, ball.deceleration, ball.stop_speed, kTickDuration);
  const bool bodies = bodies_move || world.crowded || effects.official;
  if (!bodies && !touched && world.ball.velocity == Vec2{}) return;

  Crowd crowd = crowd_of(world);
  if (bodies && keep_bodies_apart(field, contact, crowd, world)) topple(params, world);
  if (effects.official) walk_official(field, world);
  bounce_ball(field, ball, contact, effects, crowd, world);
}

/// Applies the referee's rules. A robot that returns from a penalty enters the field; after half time all robots do.
void judge(const Params& params, State& state, referee::Events& events) {
  referee::judge(referee_params(params), state.world, state.book, state.counts, events);
  for (const referee::Event& event : events) {
    if (event.kind == referee::Event::Kind::returned) enter(params, state, event.robot);
    if (event.kind == referee::Event::Kind::half_time)
      for_each_robot(state.world.players, [&](int robot) { enter(params, state, robot); });
  }
}

}  // namespace

void enter(const Params& params, State& state, int robot) {
  Robot& self = state.robots[robot];
  self = {};
  state.schedule.next = state.schedule.turn[robot] = state.schedule.radio[robot] = 0;
  state.schedule.lag[robot] = 1;
  // mirrored robots begin their search in mirrored directions
  const float sign = attack_sign(state.world, side_of(robot));
  self.mind.search_side = agent::left_or_right(sign * state.world.bodies[robot].position.y);
  perception::enter(perception_params(params, models_of(params, robot)), state.world, robot, self.beliefs,
                    self.cognition);
}

State begin(const Params& params, RandomKey key, referee::Events& events) {
  State state;
  events.count = 0;
  state.world.key = key;
  state.world.players = params.rules.players;
  referee::open(referee_params(params), state.world, state.book, events);
  for_each_robot(state.world.players, [&](int robot) { enter(params, state, robot); });
  return state;
}

namespace {

void step_round(const Params& params, std::span<State* const> games, referee::Events* events, const Tracing& tracing) {
  Round round;
  round.games = games;
  std::array<bool, kMostGames> touched;
  for (std::size_t i = 0; i < games.size(); ++i) {
    World& world = games[i]->world;
    touched[i] = world.touched != kNobody;
    events[i].count = 0;
    world.touched = world.kicked = world.whiffed = kNobody;
  }
  act(params, round, tracing);
  for (std::size_t i = 0; i < games.size(); ++i) {
    meet(params, round.due[i].moves != 0, touched[i], games[i]->world);
    judge(params, *games[i], events[i]);
    ++games[i]->world.tick;
  }
}

}  // namespace

void step_many(const Params& params, std::span<State* const> games, std::span<referee::Events> events) {
  for (std::size_t begin = 0; begin < games.size(); begin += kMostGames) {
    const std::size_t count = std::min(kMostGames, games.size() - begin);
    step_round(params, games.subspan(begin, count), &events[begin], {});
  }
}

void step(const Params& params, State& state, referee::Events& events, int traced, agent::Trace* trace) {
  State* const game = &state;
  step_round(params, {&game, 1}, &events, {traced, trace});
}

bool finished(const State& state) { return state.book.phase == agent::Game::Phase::finished; }

}  // namespace sim
