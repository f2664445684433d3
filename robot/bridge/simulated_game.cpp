#include "robot/bridge/simulated_game.h"

#include <utility>

#include "sim/agent/follower.h"
#include "sim/match/step.h"
#include "sim/math/vec2.h"

namespace robot::bridge {

SimulatedGame::SimulatedGame(const sim::Params& params, GameNames names, const sim::State& state)
    : params_(params), names_(std::move(names)) {
  begin(state);
}

void SimulatedGame::begin(const sim::State& state) { go_to({.state = state, .odometry = {}}); }

void SimulatedGame::go_to(const Moment& moment) {
  state_ = moment.state;
  odometry_ = moment.odometry;
  for (sim::agent::Trace& decision : decisions_) decision.clear();
}

void SimulatedGame::follow(int robot, const sim::agent::Choice& choice) {
  sim::agent::take_over(choice, state_.world.tick, state_.robots[robot].mind);
}

void SimulatedGame::tick(sim::referee::Events& events) {
  for (sim::agent::Trace& decision : decisions_) decision.clear();
  sim::step(params_, state_, events, sim::kEverybody, decisions_.data());
  sim::for_each_robot(state_.world.players, [this](int robot) { walk(robot); });
}

bool SimulatedGame::finished() const { return sim::finished(state_); }

const sim::agent::Trace* SimulatedGame::decision(int robot) const {
  const sim::agent::Trace& decision = decisions_[static_cast<std::size_t>(robot)];
  return *decision.skill == '\0' ? nullptr : &decision;
}

/// Adds the walk of this tick, with the error of the robot's odometry.
void SimulatedGame::walk(int robot) {
  const sim::Body& body = state_.world.bodies[robot];
  const sim::perception::Cognition& cognition = state_.robots[robot].cognition;
  sim::Pose2& pose = odometry_[static_cast<std::size_t>(robot)];
  const sim::Vec2 step = (sim::kTickDuration * cognition.odometry_scale) * body.velocity;
  pose.position += sim::turned(step, sim::direction(pose.heading));
  pose.heading = sim::normalized(pose.heading + sim::kTickDuration * cognition.turn_scale * body.turn_rate);
}

}  // namespace robot::bridge
