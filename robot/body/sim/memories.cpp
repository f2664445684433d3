#include "robot/body/sim/memories.h"

#include <algorithm>
#include <initializer_list>
#include <tuple>
#include <utility>

#include "sim/referee/referee.h"
#include "sim/world/world.h"

namespace robot::body {
namespace {

constexpr sim::Tick kGameTicks = 15, kTeamTicks = 30, kOpponentTicks = 3;  // told at least so often

/// Calls see(object) for what a simulated robot has; it has no camera and no joints.
template <class See>
void for_each_simulated(memory::Memory& memory, See&& see) {
  see(memory.odometry);
  see(memory.ball);
  see(memory.pose);
  see(memory.team);
  see(memory.opponents);
  see(memory.game);
  see(memory.motion_command);
  see(memory.motion_status);
  see(memory.decision);
}

/// What of the game is news when it changes; the clocks always do.
auto news(const sim::agent::Game& game) {
  return std::tuple(game.phase, game.set_play, game.own_kick, game.penalised, game.half, game.own_score,
                    game.opponent_score);
}

void fill(const sim::field::Field& field, foresight::Field& message) {
  message.set_length(field.length);
  message.set_width(field.width);
  message.set_border(field.border);
  message.set_line_width(field.line_width);
  message.set_centre_circle_radius(field.centre_circle_radius);
  message.set_goal_area_length(field.goal_area_length);
  message.set_goal_area_width(field.goal_area_width);
  message.set_penalty_area_length(field.penalty_area_length);
  message.set_penalty_area_width(field.penalty_area_width);
  message.set_penalty_mark(field.penalty_mark);
  message.set_goal_width(field.goal_width);
  message.set_goal_depth(field.goal_depth);
}

void fill(const Setup& setup, sim::Side side, foresight::SimulatedTeam& message) {
  message.set_number(setup.teams.of(side));
  message.set_strategy(setup.game.behaviours[static_cast<int>(side)]->name());
  message.set_models(setup.params().teams[static_cast<int>(side)].models.name);
}

}  // namespace

foresight::Simulation describe(const Setup& setup) {
  foresight::Simulation simulation;
  simulation.set_rules(setup.rules);
  fill(setup, sim::Side::home, *simulation.mutable_home());
  fill(setup, sim::Side::away, *simulation.mutable_away());
  fill(setup.params().rules.field, *simulation.mutable_field());
  return simulation;
}

Memories::Memories(const Setup& setup, int own, const Clock& clock) : own_(own) {
  sim::for_each_robot(setup.params().rules.players, [&](int robot) {
    memories_[static_cast<std::size_t>(robot)] =
        std::make_shared<memory::Memory>(agent::robot_name(setup.teams, robot), clock);
  });
}

Result<void> Memories::list(memory::Channels& channels) const {
  Result<void> listed;
  const auto add = [&](const std::shared_ptr<memory::Memory>& memory, memory::Channel& object) {
    if (listed) listed = channels.add(std::shared_ptr<memory::Channel>(memory, &object));
  };
  for (const std::shared_ptr<memory::Memory>& memory : memories_)
    if (memory) for_each_simulated(*memory, [&](memory::Channel& object) { add(memory, object); });
  memory::Memory& mine = *own();
  for (memory::Channel* object :
       std::initializer_list<memory::Channel*>{&mine.clock, &mine.runtime, &mine.log, &mine.truth, &mine.simulation,
                                               &mine.what_if, &mine.forecast, &mine.strategy, &mine.forecast_score})
    add(own(), *object);
  return listed;
}

void Memories::write(const Game& game, const agent::Timeline& timeline) {
  const sim::World& world = game.state().world;
  const std::uint64_t now_ns = timeline.at(world.tick);
  // beliefs come from the image of the tick before; between ticks there are no new ones
  const bool thought = world.tick != written_;
  std::uint64_t seen_ns = now_ns;
  if (written_ != sim::kNever)
    seen_ns = world.tick == written_ + 1 ? written_ns_ : std::max(written_ns_, timeline.at(world.tick - 1));

  sim::for_each_robot(world.players, [&](int robot) {
    const bool plays = world.bodies[robot].doing != sim::Body::Doing::removed;
    if (thought && (plays || written_ == sim::kNever)) write_mind(game, robot, timeline, seen_ns);
    write_game(game, robot, timeline);
    write_team(game, robot, timeline);
    write_body(game, robot, now_ns);
  });
  auto truth = own()->truth.draft();
  agent::to_proto(world, game.setup().teams, *truth);
  own()->truth.write(std::move(truth), now_ns);
  written_ = world.tick;
  written_ns_ = now_ns;
}

/// What an image made it believe and decide.
void Memories::write_mind(const Game& game, int robot, const agent::Timeline& timeline, std::uint64_t capture_ns) {
  const sim::Team& team = game.setup().team_of(robot);
  const sim::Robot& mind = game.state().robots[robot];
  memory::Memory& memory = *memories_[static_cast<std::size_t>(robot)];
  if (auto ball = memory.ball.draft();
      agent::to_proto(mind.beliefs.ball, team.models.ball.deceleration, timeline, *ball))
    memory.ball.write(std::move(ball), capture_ns);
  auto pose = memory.pose.draft();
  agent::to_proto(mind.beliefs.pose, *pose);
  memory.pose.write(std::move(pose), capture_ns);
  if (const sim::agent::Trace* trace = game.decision(robot)) {
    auto decision = memory.decision.draft();
    agent::to_proto(*trace, *decision);
    memory.decision.write(std::move(decision), capture_ns);
  }
  // ten times a second is as good as each image
  if (game.state().world.tick % kOpponentTicks == 0 || written_ == sim::kNever) {
    auto opponents = memory.opponents.draft();
    agent::to_proto(mind.beliefs, timeline, *opponents);
    memory.opponents.write(std::move(opponents), capture_ns);
  }
  auto command = memory.motion_command.draft();
  agent::to_proto(mind.command, team.models.motion, *command);
  memory.motion_command.write(std::move(command), capture_ns);
}

/// What its body does since.
void Memories::write_body(const Game& game, int robot, std::uint64_t capture_ns) {
  const sim::State& state = game.state();
  const sim::Team& team = game.setup().team_of(robot);
  memory::Memory& memory = *memories_[static_cast<std::size_t>(robot)];
  auto status = memory.motion_status.draft();
  agent::to_proto(state.world.bodies[robot], state.robots[robot].command, team.models.motion, state.world.tick,
                  *status);
  memory.motion_status.write(std::move(status), capture_ns);
  auto odometry = memory.odometry.draft();
  odometry->set_x(game.odometry(robot).position.x);
  odometry->set_y(game.odometry(robot).position.y);
  odometry->set_heading(game.odometry(robot).heading);
  memory.odometry.write(std::move(odometry), capture_ns);
}

void Memories::write_game(const Game& game, int robot, const agent::Timeline& timeline) {
  const sim::State& state = game.state();
  Told& told = told_[static_cast<std::size_t>(robot)];
  const sim::agent::Game now = sim::referee::game_for(game.setup().params().rules, state.world, state.book, robot);
  if (written_ != sim::kNever && news(now) == news(told.game) && state.world.tick % kGameTicks != 0) return;
  told.game = now;
  memory::Memory& memory = *memories_[static_cast<std::size_t>(robot)];
  auto message = memory.game.draft();
  agent::to_proto(game.setup().params(), state, robot, game.setup().teams, timeline, *message);
  memory.game.write(std::move(message), timeline.at(state.world.tick));
}

void Memories::write_team(const Game& game, int robot, const agent::Timeline& timeline) {
  const sim::State& state = game.state();
  const sim::agent::Beliefs& beliefs = state.robots[robot].beliefs;
  Told& told = told_[static_cast<std::size_t>(robot)];
  std::array<sim::Tick, sim::agent::kMaxMates> sent;
  for (std::size_t mate = 0; mate < sent.size(); ++mate) sent[mate] = beliefs.mates[mate].sent;
  if (written_ != sim::kNever && sent == told.mates && state.world.tick % kTeamTicks != 0) return;
  told.mates = sent;
  memory::Memory& memory = *memories_[static_cast<std::size_t>(robot)];
  auto message = memory.team.draft();
  agent::to_proto(beliefs, sim::player_of(robot), timeline, *message);
  if (const sim::Tick last = state.robots[robot].cognition.packet.sent; last != sim::kNever)
    message->set_sent_ns(timeline.at(last));
  memory.team.write(std::move(message), timeline.at(state.world.tick));
}

}  // namespace robot::body
