#include "robot/bridge/narrator.h"

#include <algorithm>
#include <initializer_list>
#include <tuple>
#include <utility>

#include "sim/match/pace.h"
#include "sim/referee/referee.h"
#include "sim/world/world.h"

namespace robot::bridge {
namespace {

constexpr sim::Tick kGameTicks = 15, kTeamTicks = 30, kOpponentTicks = 3;  // longest time between two messages

/// Calls see(object) for each object of a simulated robot, which has no pictures and no joints.
template <class See>
void for_each_simulated(memory::Memory& memory, See&& see) {
  see(memory.camera_top_matrix);
  see(memory.odometry);
  see(memory.vision);
  see(memory.ball);
  see(memory.pose);
  see(memory.team);
  see(memory.opponents);
  see(memory.game);
  see(memory.motion_command);
  see(memory.motion_status);
  see(memory.decision);
}

/// Returns the facts whose change is written at once. The clocks change always.
auto news(const sim::agent::Game& game) {
  return std::tuple(game.phase, game.set_play, game.own_kick, game.penalised, game.half, game.own_score,
                    game.opponent_score);
}

void fill(const SimulatedGame& game, sim::Side side, foresight::SimulatedTeam& message) {
  const sim::Team& team = game.params().teams[static_cast<int>(side)];
  message.set_number(game.names().teams.of(side));
  message.set_strategy(team.behaviour->name());
  message.set_models(team.models.name);
}

/// Returns the facts that stay the same during a run: rules, teams, field.
foresight::Simulation describe(const SimulatedGame& game) {
  foresight::Simulation simulation;
  simulation.set_rules(game.names().rules);
  simulation.set_thinned(game.params().pace == sim::Pace::thinned);
  fill(game, sim::Side::home, *simulation.mutable_home());
  fill(game, sim::Side::away, *simulation.mutable_away());
  to_proto(game.params().rules.field, *simulation.mutable_field());
  return simulation;
}

}  // namespace

Narrator::Narrator(const SimulatedGame& game, int own, const Clock& clock) : own_(own), simulation_(describe(game)) {
  last_packet_.fill(sim::kNever);
  sim::for_each_robot(game.params().rules.players, [&](int robot) {
    memories_[static_cast<std::size_t>(robot)] =
        std::make_shared<memory::Memory>(robot_name(game.names().teams, robot), clock);
  });
}

Result<void> Narrator::list(memory::Channels& channels) const {
  Result<void> listed;
  const auto add = [&](const std::shared_ptr<memory::Memory>& memory, memory::Channel& object) {
    if (listed) listed = channels.add(std::shared_ptr<memory::Channel>(memory, &object));
  };
  for (const std::shared_ptr<memory::Memory>& memory : memories_)
    if (memory) for_each_simulated(*memory, [&](memory::Channel& object) { add(memory, object); });
  add(own(), own()->truth);
  add(own(), own()->simulation);
  return listed;
}

void Narrator::write(const SimulatedGame& game, const Timeline& timeline) {
  const sim::World& world = game.state().world;
  const std::uint64_t now_ns = timeline.at(world.tick);
  // beliefs come from the image at the beginning of the tick; without a tick there are no new ones
  const bool thought = world.tick != written_;
  std::uint64_t seen_ns = now_ns;
  if (written_ != sim::kNever)
    seen_ns = world.tick == written_ + 1 ? written_ns_ : std::max(written_ns_, timeline.at(world.tick - 1));

  sim::for_each_robot(world.players, [&](int robot) {
    const bool plays = world.bodies[robot].doing != sim::Body::Doing::removed;
    if (thought) write_image(game, robot, seen_ns);
    if (thought && (plays || written_ == sim::kNever)) write_mind(game, robot, timeline, seen_ns);
    write_game(game, robot, timeline);
    write_team(game, robot, timeline);
    write_body(game, robot, now_ns);
  });
  auto truth = own()->truth.draft();
  to_proto(sim::between_turns(game.state()), game.names().teams, *truth);
  own()->truth.write(std::move(truth), now_ns);
  written_ = world.tick;
  written_ns_ = now_ns;
}

/// Writes the camera and its percepts, if the robot took an image.
void Narrator::write_image(const SimulatedGame& game, int robot, std::uint64_t capture_ns) {
  const SimulatedImage image = game.image(robot);
  if (!image.taken) return;
  const sim::Models& own = sim::models_of(game.params(), robot);
  memory::Memory& memory = *memories_[static_cast<std::size_t>(robot)];
  auto matrix = memory.camera_top_matrix.draft();
  to_proto(image, own.perception.camera, *matrix);
  memory.camera_top_matrix.write(std::move(matrix), capture_ns);
  auto vision = memory.vision.draft();
  to_proto(image, own, *vision);
  memory.vision.write(std::move(vision), capture_ns);
}

/// Writes the beliefs and the decision that came from an image.
void Narrator::write_mind(const SimulatedGame& game, int robot, const Timeline& timeline, std::uint64_t capture_ns) {
  const sim::Models& own = sim::models_of(game.params(), robot);
  const sim::Robot& mind = game.state().robots[robot];
  memory::Memory& memory = *memories_[static_cast<std::size_t>(robot)];
  if (auto ball = memory.ball.draft();
      to_proto(mind.beliefs.ball, game.team_of(robot).models.ball.deceleration, timeline, *ball))
    memory.ball.write(std::move(ball), capture_ns);
  auto pose = memory.pose.draft();
  to_proto(mind.beliefs.pose, *pose);
  memory.pose.write(std::move(pose), capture_ns);
  if (const sim::agent::Trace* trace = game.decision(robot)) {
    auto decision = memory.decision.draft();
    to_proto(*trace, *decision);
    memory.decision.write(std::move(decision), capture_ns);
  }
  // ten times a second is enough
  if (game.state().world.tick % kOpponentTicks == 0 || written_ == sim::kNever) {
    auto opponents = memory.opponents.draft();
    to_proto(mind.beliefs, timeline, *opponents);
    memory.opponents.write(std::move(opponents), capture_ns);
  }
  auto command = memory.motion_command.draft();
  to_proto(mind.command, own.motion, *command);
  memory.motion_command.write(std::move(command), capture_ns);
}

/// Writes the state of the body at the end of the tick.
void Narrator::write_body(const SimulatedGame& game, int robot, std::uint64_t capture_ns) {
  const sim::State& state = game.state();
  const sim::Models& own = sim::models_of(game.params(), robot);
  memory::Memory& memory = *memories_[static_cast<std::size_t>(robot)];
  auto status = memory.motion_status.draft();
  to_proto(state.world.bodies[robot], state.robots[robot].command, own.motion, state.world.tick, *status);
  memory.motion_status.write(std::move(status), capture_ns);
  auto odometry = memory.odometry.draft();
  odometry->set_x(game.odometry(robot).position.x);
  odometry->set_y(game.odometry(robot).position.y);
  odometry->set_heading(game.odometry(robot).heading);
  memory.odometry.write(std::move(odometry), capture_ns);
}

void Narrator::write_game(const SimulatedGame& game, int robot, const Timeline& timeline) {
  const sim::State& state = game.state();
  Told& told = told_[static_cast<std::size_t>(robot)];
  const sim::agent::Game now = sim::referee::game_for(game.params().rules, state.world, state.book, robot);
  if (written_ != sim::kNever && news(now) == news(told.game) && state.world.tick % kGameTicks != 0) return;
  told.game = now;
  memory::Memory& memory = *memories_[static_cast<std::size_t>(robot)];
  auto message = memory.game.draft();
  to_proto(game.params(), state, robot, game.names().teams, timeline, *message);
  memory.game.write(std::move(message), timeline.at(state.world.tick));
}

void Narrator::write_team(const SimulatedGame& game, int robot, const Timeline& timeline) {
  const sim::State& state = game.state();
  const sim::agent::Beliefs& beliefs = state.robots[robot].beliefs;
  const auto index = static_cast<std::size_t>(robot);
  const sim::Tick last = state.robots[robot].cognition.packet.sent;
  if (last != std::exchange(last_packet_[index], last) && last != sim::kNever) ++packets_[index];

  Told& told = told_[index];
  std::array<sim::Tick, sim::agent::kMaxMates> sent;
  for (std::size_t mate = 0; mate < sent.size(); ++mate) sent[mate] = beliefs.mates[mate].sent;
  if (written_ != sim::kNever && sent == told.mates && state.world.tick % kTeamTicks != 0) return;
  told.mates = sent;
  memory::Memory& memory = *memories_[static_cast<std::size_t>(robot)];
  auto message = memory.team.draft();
  to_proto(beliefs, sim::player_of(robot), timeline, *message);
  if (last != sim::kNever) message->set_sent_ns(timeline.at(last));
  message->set_messages_sent(packets_[index]);
  memory.team.write(std::move(message), timeline.at(state.world.tick));
}

void Narrator::write_status(const SimulatedGame& game, const Pacing& pacing, const Timeline& timeline) {
  const sim::State& state = game.state();
  simulation_.set_paused(pacing.paused);
  simulation_.set_finished(game.finished());
  simulation_.set_speed(static_cast<float>(pacing.speed));
  simulation_.set_seed(state.world.key.seed);
  simulation_.set_tick(state.world.tick);
  simulation_.set_ticks_behind(pacing.ticks_behind);
  simulation_.mutable_home()->set_score(state.book.score[0]);
  simulation_.mutable_away()->set_score(state.book.score[1]);
  own()->simulation.write(simulation_, timeline.at(state.world.tick));
}

}  // namespace robot::bridge
