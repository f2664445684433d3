#include "robot/bridge/simulated_game.h"

#include <cmath>
#include <utility>

#include "sim/agent/follower.h"
#include "sim/match/pace.h"
#include "sim/match/step.h"
#include "sim/math/random.h"
#include "sim/math/vec2.h"

namespace robot::bridge {
namespace {

constexpr float kLongestStep = 0.1f;  // [m] in a tick, 3 m/s: a longer one is the referee's

}  // namespace

SimulatedGame::SimulatedGame(const sim::Params& params, GameNames names, const sim::State& state)
    : params_(params), names_(std::move(names)) {
  begin(state);
}

void SimulatedGame::begin(const sim::State& state) { go_to({.state = state, .odometry = {}}); }

void SimulatedGame::go_to(const Moment& moment) {
  state_ = moment.state;
  odometry_ = moment.odometry;
  for (sim::agent::Trace& decision : decisions_) decision.clear();
  seen_.reset();
}

void SimulatedGame::follow(int robot, const sim::agent::Choice& choice) {
  sim::agent::take_over(choice, state_.world.tick, state_.robots[robot].mind);
}

void SimulatedGame::tick(sim::referee::Events& events) {
  for (sim::agent::Trace& decision : decisions_) decision.clear();
  seen_ = sim::between_turns(state_);
  sim::step(params_, state_, events, sim::kEverybody, decisions_.data());
  const sim::World after = sim::between_turns(state_);
  sim::for_each_robot(state_.world.players, [&](int robot) { walk(*seen_, after, robot); });
}

bool SimulatedGame::finished() const { return sim::finished(state_); }

const sim::agent::Trace* SimulatedGame::decision(int robot) const {
  const sim::agent::Trace& decision = decisions_[static_cast<std::size_t>(robot)];
  return *decision.skill == '\0' ? nullptr : &decision;
}

/// Adds the walk of this tick, with the errors of the robot's odometry.
void SimulatedGame::walk(const sim::World& before, const sim::World& after, int robot) {
  const sim::Body &from = before.bodies[robot], &to = after.bodies[robot];
  if (from.doing == sim::Body::Doing::removed || to.doing == sim::Body::Doing::removed) return;
  sim::Vec2 moved = sim::turned_back(to.position - from.position, from.facing);
  float turned = sim::normalized(to.heading - from.heading);
  const float way = sim::length(moved), angle = std::fabs(turned);
  if ((way == 0 && angle == 0) || way > kLongestStep) return;

  const sim::Models& own = sim::models_of(params_, robot);
  const sim::perception::Cognition& cognition = state_.robots[robot].cognition;
  moved = cognition.odometry_scale * moved;
  turned *= cognition.turn_scale;
  if (own.effects.odometry_drift) {
    const sim::perception::Localisation& model = own.perception.localisation;
    const auto errors =
        sim::normals(sim::draw(before.key, static_cast<std::uint32_t>(robot), sim::Draw::odometry_noise, before.tick));
    moved += model.translation_noise * std::sqrt(way) * sim::Vec2{errors[0], errors[1]};
    turned +=
        std::hypot(model.rotation_noise * std::sqrt(angle), model.rotation_per_metre * std::sqrt(way)) * errors[2];
  }
  sim::Pose2& pose = odometry_[static_cast<std::size_t>(robot)];
  pose.position += sim::turned(moved, sim::direction(pose.heading));
  pose.heading = sim::normalized(pose.heading + turned);
}

}  // namespace robot::bridge
