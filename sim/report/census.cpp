#include "sim/report/census.h"

#include <cmath>

#include "robot/core/json_library.h"
#include "sim/math/angles.h"
#include "sim/perception/localisation.h"

namespace sim::report {
namespace {

using Doing = Body::Doing;

constexpr float kLying = 0.1f;             // [m/s]
constexpr float kMoving = 0.5f;            // [m/s]
constexpr float kAstray = 10 * kPi / 180;  // [rad]
constexpr float kAstrayFrom = 0.5f;        // [m] nearer, every error is a large angle

double angle_between(Vec2 a, Vec2 b) { return std::abs(std::atan2(double(cross(a, b)), double(dot(a, b)))); }

double seconds(Tick now, Tick then) { return static_cast<double>(age(now, then)); }

}  // namespace

void Census::look(const State& state) {
  if (state.book.phase == agent::Game::Phase::playing && state.world.tick == before_.tick + 1) {
    for_each_robot(state.world.players, [&](int robot) {
      // beliefs are as old as the robot's last turn
      const bool had_turn = state.schedule.turn[robot] == before_.tick + state.schedule.lag[robot];
      if (had_turn && on_field(before_.bodies[robot]))
        look_at(state, robot, figures_[static_cast<int>(side_of(robot))]);
    });
    look_at_ball(state);
  }
  before_ = state.world;
}

void Census::look_at(const State& state, int robot, Figures& figures) const {
  const Body& body = before_.bodies[robot];
  const agent::Beliefs& beliefs = state.robots[robot].beliefs;
  const double weight = state.schedule.lag[robot];

  if (beliefs.ball.visible) {
    const Vec2 ball = turned_back(before_.ball.position - body.position, body.facing);
    const double error = length(beliefs.ball.position - ball);
    figures.ball_error.add(error, weight);
    if (length(before_.ball.velocity) > kMoving) figures.moving_ball_error.add(error, weight);
    if (length(beliefs.ball.position) > kAstrayFrom)
      figures.ball_astray.add(angle_between(beliefs.ball.position, ball) > kAstray ? 1 : 0, weight);
  }

  const Pose2 pose = perception::true_pose(before_, robot);
  figures.pose_error.add(length(beliefs.pose.pose.position - pose.position), weight);
  figures.flipped.add(state.robots[robot].cognition.flipped ? 1 : 0, weight);

  for (int mate = 0; mate < state.world.players - 1; ++mate)
    if (beliefs.mates[mate].sent != kNever)
      figures.news_age.add(seconds(before_.tick, beliefs.mates[mate].sent), weight);

  if (body.doing == Doing::walking) figures.speed.add(length(body.velocity), weight);
  figures.shifting.add(body.doing == Doing::starting || body.doing == Doing::stopping ? 1 : 0, weight);
  figures.down.add(lies(body) ? 1 : 0, weight);
}

void Census::look_at_ball(const State& state) {
  const World& world = state.world;
  if (world.touched == kNobody || world.ball.velocity == Vec2{}) return;
  const Side side = side_of(world.touched);
  Figures& figures = figures_[static_cast<int>(side)];
  if (world.kicked == world.touched) {
    const Vec2 aim = direction(state.robots[world.kicked].mind.kick_direction);
    figures.kick_astray.add(angle_between(attack_sign(world, side) * aim, world.ball.velocity));
    return;
  }
  const Body& body = world.bodies[world.touched];
  if (body.velocity != Vec2{} && length(before_.ball.velocity) < kLying)
    figures.push_astray.add(angle_between(world.ball.position - body.position, world.ball.velocity));
}

nlohmann::ordered_json Census::of(Side side) const {
  const Figures& figures = figures_[static_cast<int>(side)];
  return {{"ball_error", figures.ball_error.mean()},
          {"moving_ball_error", figures.moving_ball_error.mean()},
          {"ball_astray", figures.ball_astray.mean()},
          {"pose_error", figures.pose_error.mean()},
          {"flipped", figures.flipped.mean()},
          {"news_age", figures.news_age.mean()},
          {"speed", figures.speed.mean()},
          {"shifting", figures.shifting.mean()},
          {"down", figures.down.mean()},
          {"kick_astray", figures.kick_astray.mean()},
          {"push_astray", figures.push_astray.mean()}};
}

}  // namespace sim::report
