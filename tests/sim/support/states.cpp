#include "tests/sim/support/states.h"

#include <algorithm>

#include "sim/agent/mirror.h"
#include "sim/match/fields.h"

namespace sim::test {

State scrambled(std::uint64_t seed) {
  State state{};
  std::uint32_t number = 0;
  visit_fields(state, [&](const FieldPath&, auto& field) {
    using Field = std::remove_reference_t<decltype(field)>;
    const std::uint32_t word = draw({seed}, kNobody, Draw::situation, number++)[0];
    if constexpr (std::is_same_v<Field, float>)
      field = 200 * uniform(word) - 100;
    else if constexpr (std::is_same_v<Field, bool>)
      field = word % 2 == 1;
    else if constexpr (std::is_enum_v<Field>)
      field = static_cast<Field>(word % (last_of<Field>() + 1));
    else
      field = static_cast<Field>(word);
  });

  // counts and indices of arrays must be possible
  World& world = state.world;
  world.players = 1 + (world.players & 3);
  world.home_attacks = world.home_attacks > 0 ? 1.f : -1.f;
  world.touched = world.kicked = world.whiffed = state.book.last_toucher = state.book.kick_off_by = kNobody;
  for (int i = 0; i < kMaxRobots; ++i)
    world.bodies[i].kind = state.robots[i].command.kick = state.robots[i].mind.kick = 0;
  return state;
}

namespace {

Vec2 across(Vec2 a) { return {a.x, -a.y}; }
Pose2 across(Pose2 pose) { return {across(pose.position), -pose.heading}; }

Body across(Body body) {
  body.position = across(body.position);
  body.heading = -body.heading;
  body.facing = across(body.facing);
  body.velocity = across(body.velocity);
  body.turn_rate = -body.turn_rate;
  body.head_yaw = -body.head_yaw;
  body.look = across(body.look);
  body.kick_left = !body.kick_left;
  body.step_velocity.y = -body.step_velocity.y;
  body.step_turn_rate = -body.step_turn_rate;
  return body;
}

World across(World world) {
  Ball& ball = world.ball;
  ball.position = across(ball.position);
  ball.velocity = across(ball.velocity);
  ball.acceleration = across(ball.acceleration);
  for (Vec2& past : ball.past) past = across(past);
  world.official = {across(world.official.position), across(world.official.velocity)};
  for (Body& body : world.bodies) body = across(body);
  return world;
}

/// Exchanges the two halves of a list by robot.
template <class Value>
void exchange(Value (&list)[kMaxRobots]) {
  std::swap_ranges(list, list + kMaxPlayers, list + kMaxPlayers);
}

}  // namespace

State mirrored(const State& state) {
  State image = state;
  image.world = across(state.world);
  referee::Book& book = image.book;
  for (Vec2* place : {&book.last_touch_at, &book.ball_before, &book.stuck_at}) *place = across(*place);
  for (Robot& robot : image.robots) {
    robot.command = agent::mirrored(robot.command);
    robot.beliefs = agent::mirrored(robot.beliefs);
    robot.mind = agent::mirrored(robot.mind);
    robot.cognition.last = across(robot.cognition.last);
    agent::Mate& packet = robot.cognition.packet;
    packet.pose = across(packet.pose);
    packet.ball = across(packet.ball);
  }
  return image;
}

State exchanged(const State& state) {
  State other_names = state;
  World& world = other_names.world;
  world.home_attacks = -world.home_attacks;
  exchange(world.bodies);
  exchange(other_names.robots);
  Schedule& schedule = other_names.schedule;
  exchange(schedule.turn), exchange(schedule.radio), exchange(schedule.lag), exchange(schedule.lost);
  referee::Book& book = other_names.book;
  for (std::uint8_t* robot : {&world.touched, &world.kicked, &world.whiffed, &book.last_toucher, &book.kick_off_by})
    if (*robot != kNobody) *robot = static_cast<std::uint8_t>((*robot + kMaxPlayers) % kMaxRobots);

  for (Side* side : {&book.kicking, &book.first_kick_off, &book.last_touch}) *side = other(*side);
  std::swap(book.score[0], book.score[1]);
  std::swap(book.packets[0], book.packets[1]);
  std::swap(book.penalties[0], book.penalties[1]);
  exchange(book.penalised_until);

  referee::GameCounts& counts = other_names.counts;
  for (auto* pair : {&counts.kicks, &counts.whiffs, &counts.shots}) std::swap((*pair)[0], (*pair)[1]);
  std::swap(counts.possession[0], counts.possession[1]);
  exchange(counts.seen);
  return other_names;
}

Params exchanged(const Params& params) {
  Params other_names = params;
  std::swap(other_names.teams[0], other_names.teams[1]);
  return other_names;
}

State as_it_matters(State state) {
  visit_fields(state, [](const FieldPath&, auto& field) {
    if constexpr (std::is_same_v<std::remove_reference_t<decltype(field)>, float>)
      if (field == -kPi) field = kPi;
  });
  for (int i = 0; i < kMaxRobots; ++i) {
    Body& body = state.world.bodies[i];
    if (body.doing != Body::Doing::kicking) body.kick_left = false;
    motion::Command& command = state.robots[i].command;
    if (command.body != motion::Command::Body::kick) command.kick_left = false;
  }
  return state;
}

}  // namespace sim::test
