#include "robot/body/sim/game.h"

#include <utility>

#include "sim/agent/follower.h"
#include "sim/match/step.h"
#include "sim/referee/event.h"

namespace robot::body {

Game::Game(Setup setup, std::uint64_t seed) : setup_(std::move(setup)) { begin(seed); }

void Game::begin(std::uint64_t seed) {
  sim::referee::Events events;
  begin(sim::begin(setup_.params(), {seed}, events));
}

void Game::begin(const sim::State& situation) {
  state_ = situation;
  for (sim::agent::Trace& decision : decisions_) decision.clear();
  odometry_.fill({});
}

void Game::follow(int robot, const sim::agent::Choice& choice) {
  sim::agent::take_over(choice, state_.world.tick, state_.robots[robot].mind);
}

void Game::tick() {
  for (sim::agent::Trace& decision : decisions_) decision.clear();
  sim::referee::Events events;
  sim::step(setup_.params(), state_, events, sim::kEverybody, decisions_.data());
  sim::for_each_robot(state_.world.players, [this](int robot) { walk(robot); });
}

bool Game::finished() const { return sim::finished(state_); }

const sim::agent::Trace* Game::decision(int robot) const {
  const sim::agent::Trace& decision = decisions_[static_cast<std::size_t>(robot)];
  return *decision.skill == '\0' ? nullptr : &decision;
}

// what its feet did in this tick, off by what its odometry is off
void Game::walk(int robot) {
  const sim::Body& body = state_.world.bodies[robot];
  const sim::perception::Cognition& cognition = state_.robots[robot].cognition;
  sim::Pose2& pose = odometry_[static_cast<std::size_t>(robot)];
  const sim::Vec2 step = (sim::kTickDuration * cognition.odometry_scale) * body.velocity;
  pose.position += sim::turned(step, sim::direction(pose.heading));
  pose.heading = sim::normalized(pose.heading + sim::kTickDuration * cognition.turn_scale * body.turn_rate);
}

}  // namespace robot::body
