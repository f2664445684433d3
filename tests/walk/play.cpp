#include "tests/walk/play.h"

#include <algorithm>
#include <cmath>

#include "robot/agent/agent.h"
#include "robot/nao/walk/odometry.h"
#include "tests/walk/dice.h"
#include "tests/walk/plans.h"
#include "tests/walk/robot_in_physics.h"

namespace robot::nao {
namespace {

namespace pb = foresight;

constexpr std::uint64_t kDecision_ns = 33'333'333;
constexpr double kFrame = 0.012;                       // [s] of LoLA
constexpr double kWatched = 0.5;                       // [s] after a step that kicks
constexpr double kGoalHalf = 0.75;                     // [m] half of the goal's width
constexpr double kBallAhead = 0.7, kBallAside = 0.25;  // [m]
constexpr double kAwayFromGoal = 2.5;                  // [m] the physics' origin is this far before the opponent's goal

/// The beliefs of good eyes and a good localisation: the truth with errors.
class Eyes {
 public:
  explicit Eyes(std::uint64_t seed) : dice_(seed) {}

  bridge::Recollection believe(const RobotInPhysics& robot) {
    const walk::Truth truth = robot.body.truth();
    bridge::Recollection beliefs{.now_ns = robot.now_ns};
    beliefs.pose = {pose(truth), robot.now_ns};
    beliefs.ball = {ball(truth, robot.now_ns), robot.now_ns};
    beliefs.game = {alone(), robot.now_ns};
    beliefs.motion = {robot.status(), robot.now_ns};
    return beliefs;
  }

 private:
  static constexpr double kSeen = 1.3;  // [rad] to both sides, with a turning head

  pb::Pose pose(const walk::Truth& truth) {
    pb::Pose pose;
    pose.set_x(static_cast<float>(4.5 - kAwayFromGoal + truth.x + 0.03 * dice_.normal()));
    pose.set_y(static_cast<float>(truth.y + 0.03 * dice_.normal()));
    pose.set_heading(static_cast<float>(truth.heading + 0.02 * dice_.normal()));
    pose.set_deviation_x(0.03f), pose.set_deviation_y(0.03f), pose.set_deviation_heading(0.02f);
    return pose;
  }

  /// A ball out of sight stays where it was seen last.
  pb::Ball ball(const walk::Truth& truth, std::uint64_t now_ns) {
    const walk::Way here{truth.x, truth.y, truth.heading};
    const auto [ahead, left, height] = walk::passed({}, {truth.ball_x, truth.ball_y, 0}, here);
    const double distance = std::hypot(ahead, left);
    pb::Ball ball;
    ball.set_visible(std::abs(std::atan2(left, ahead)) < kSeen);
    if (ball.visible()) {
      believed_ = {ahead * (1 + 0.03 * dice_.normal()), left + 0.01 * distance * dice_.normal(), 0};
      seen_from_ = here, seen_ns_ = now_ns;
      const double direction = truth.ball_direction - truth.heading;
      ball.set_frames_visible(10);
      ball.set_velocity_x(static_cast<float>(truth.ball_speed * std::cos(direction)));
      ball.set_velocity_y(static_cast<float>(truth.ball_speed * std::sin(direction)));
    }
    const walk::Point place = walk::passed(seen_from_, believed_, here);
    ball.set_x(static_cast<float>(place.x));
    ball.set_y(static_cast<float>(place.y));
    ball.set_seen_ns(seen_ns_);
    ball.set_deviation(static_cast<float>(0.01 + 0.03 * distance));
    return ball;
  }

  /// A game in which only player 2 is on the field.
  static pb::GameState alone() {
    pb::GameState game;
    game.set_state(pb::GameState::STATE_PLAYING);
    game.set_phase(pb::GameState::PHASE_NORMAL);
    game.set_half(1), game.set_seconds_remaining(300), game.set_players_per_team(5);
    game.set_own_team(14), game.set_own_player(2);
    game.mutable_own()->set_goalkeeper(1), game.mutable_opponent()->set_goalkeeper(1);
    for (int player = 1; player <= 5; ++player) {
      game.mutable_own()->add_players()->set_penalised(player != 2);
      game.mutable_opponent()->add_players()->set_penalised(true);
    }
    return game;
  }

  walk::Dice dice_;
  walk::Point believed_;  // [m, robot] the ball
  walk::Way seen_from_;
  std::uint64_t seen_ns_ = 0;
};

/// Watches the steps that kick, and the ball after them.
class Kicks {
 public:
  /// Takes a frame: whether a kick is commanded, whether the present step kicks, and the ball's speed [m/s].
  void see(bool commanded, bool kicks, double ball_speed) {
    unasked_ = commanded ? 0 : unasked_ + kFrame;
    asked_ = unasked_ > kForgotten ? 0 : asked_ + kFrame;
    if (kicks && !kicking_) speeds_.push_back(0), waits_.push_back(asked_), asked_ = 0, unasked_ = 2 * kForgotten;
    kicking_ = kicks;
    since_ = kicks ? 0 : since_ + kFrame;
    if (!speeds_.empty() && since_ < kWatched) speeds_.back() = std::max(speeds_.back(), ball_speed);
  }
  const std::vector<double>& speeds() const { return speeds_; }
  const std::vector<double>& waits() const { return waits_; }

 private:
  static constexpr double kForgotten = 1;  // [s] without a command for it, a kick is over

  bool kicking_ = false;
  double since_ = 0;             // [s] the last step that kicked
  double asked_ = 0;             // [s] the first command of this kick
  double unasked_ = kForgotten;  // [s] the last command of a kick
  std::vector<double> speeds_, waits_;
};

}  // namespace

Played play_alone(walk::Servos servos, std::uint64_t seed, double seconds) {
  Played played;
  auto agent = agent::Agent::load({.models = "nao"});
  if (!agent) {
    played.trouble = agent.error();
    return played;
  }
  RobotInPhysics robot(servos, seed, true);
  robot.body.place_ball(kBallAhead, kBallAside * (2 * walk::drawn(seed, 3) - 1));
  Eyes eyes(seed);
  Kicks kicks;
  std::uint64_t next_ns = 0;
  while (played.seconds < seconds && !played.scored && !played.fell && played.trouble.empty()) {
    if (robot.now_ns >= next_ns) {
      const auto decision = agent->decide(eyes.believe(robot));
      played.trouble = decision.problem;
      robot.command = decision.command;
      next_ns = robot.now_ns + kDecision_ns;
    }
    robot.cycle();
    played.seconds += kFrame;
    const walk::Truth now = robot.body.truth();
    kicks.see(robot.command.has_kick(), robot.motion.kicks(), now.ball_speed);
    played.fell = !robot.body.upright();
    played.scored = now.ball_x > kAwayFromGoal && std::abs(now.ball_y) < kGoalHalf;
    if (played.trouble.empty()) played.trouble = robot.motion.refused();
  }
  played.kicks = kicks.speeds(), played.waits = kicks.waits();
  return played;
}

}  // namespace robot::nao
