// The synthetic robot's pose, game state, team and decisions, and the ground truth.
#include <algorithm>
#include <cmath>
#include <numbers>

#include "robot/lab/synthetic/synthetic_messages.h"

namespace robot::lab::synthetic {
namespace {

constexpr double kKickReach = 0.28;  // [m]

std::uint64_t ns(const SyntheticMoment& moment, double t) {
  return moment.epoch_ns + static_cast<std::uint64_t>(std::llround(t * 1e9));
}

pb::GameState::State state_at(double t) {
  if (t < kReady) return pb::GameState::STATE_INITIAL;
  if (t < kSet) return pb::GameState::STATE_READY;
  if (t < kPlaying) return pb::GameState::STATE_SET;
  if (t < kGoal) return pb::GameState::STATE_PLAYING;
  return t < kSetAgain ? pb::GameState::STATE_READY : pb::GameState::STATE_SET;
}

void fill_team(std::uint32_t number, pb::TeamState::Colour colour, std::uint32_t score, double t, pb::TeamState& team) {
  team.set_number(number);
  team.set_field_colour(colour);
  team.set_goalkeeper_colour(number == 14 ? pb::TeamState::COLOUR_YELLOW : pb::TeamState::COLOUR_BLACK);
  team.set_goalkeeper(1);
  team.set_score(score);
  team.set_message_budget(1200 - static_cast<std::uint32_t>(std::clamp(t - kReady, 0.0, 1000.0)));
  for (int player = 1; player <= 3; ++player) team.add_players();
}

/// Adds one comparison to the trace of the decision tree.
bool ask(pb::DecisionTrace& trace, const std::string& name, const std::string& condition, const std::string& feature,
         std::optional<double> value, double threshold, bool result) {
  pb::DecisionTrace::Node& node = *trace.add_visited();
  node.set_kind(pb::DecisionTrace::Node::KIND_CONDITION);
  node.set_name(name);
  node.set_path("play/" + name);
  node.set_condition(condition);
  node.set_feature(feature);
  if (value) node.set_value(narrow(*value));
  node.set_threshold(narrow(threshold));
  node.set_result(result);
  return result;
}

void choose(pb::DecisionTrace& trace, const std::string& skill) {
  pb::DecisionTrace::Node& node = *trace.add_visited();
  node.set_kind(pb::DecisionTrace::Node::KIND_SKILL);
  node.set_name(skill);
  node.set_path("play/" + skill);
  node.set_result(true);
  trace.set_skill(skill);
}

}  // namespace

pb::Pose pose_of(const SyntheticMoment& moment, const Noise& noise) {
  // the pose is unknown at first, found within seconds, and never exact
  const double lost = std::exp(-moment.t / 1.5), deviation = 0.08 + 0.5 * lost;
  const double drift_x = 0.05 * std::sin(0.5 * moment.t), drift_y = 0.05 * std::cos(0.37 * moment.t);
  const Walker walker = walker_at(moment.t);
  const auto jitter = [&](Noise::Stream stream) { return noise(stream, moment.step); };
  pb::Pose pose;
  pose.set_x(narrow(walker.position.x + drift_x + 0.4 * lost + 0.008 * jitter(Noise::kPoseX)));
  pose.set_y(narrow(walker.position.y + drift_y - 0.3 * lost + 0.008 * jitter(Noise::kPoseY)));
  pose.set_heading(narrow(
      normalised(walker.heading + 0.03 * std::sin(0.6 * moment.t) + 0.3 * lost + 0.01 * jitter(Noise::kPoseHeading))));
  pose.set_deviation_x(narrow(deviation));
  pose.set_deviation_y(narrow(0.8 * deviation));
  pose.set_deviation_heading(narrow(0.05 + 0.4 * lost));
  constexpr std::uint64_t kParticles = 30;
  for (std::uint64_t i = 0; i < kParticles; ++i) {
    const auto off = [&](std::uint64_t axis) {
      return noise(Noise::kParticles, 3 * (kParticles * moment.step + i) + axis);
    };
    pb::Pose::Particle& particle = *pose.add_particles();
    particle.set_x(narrow(pose.x() + deviation * off(0)));
    particle.set_y(narrow(pose.y() + 0.8 * deviation * off(1)));
    particle.set_heading(narrow(normalised(pose.heading() + (0.05 + 0.4 * lost) * off(2))));
    particle.set_weight(1.0f / kParticles);
  }
  return pose;
}

pb::Team team_of(const SyntheticMoment& moment) {
  pb::Team team;
  const auto ball = ball_at(moment.t);
  for (const OtherRobot& robot : others_at(moment.t)) {
    if (robot.team != 14) continue;
    pb::Teammate& mate = *team.add_teammates();
    mate.set_player(static_cast<std::uint32_t>(robot.player));
    mate.set_role(robot.player == 1 ? "keeper" : "supporter");
    mate.mutable_pose()->set_x(narrow(robot.position.x));
    mate.mutable_pose()->set_y(narrow(robot.position.y));
    mate.mutable_pose()->set_heading(narrow(robot.heading));
    mate.mutable_pose()->set_deviation_x(0.1f);
    mate.mutable_pose()->set_deviation_y(0.1f);
    mate.mutable_pose()->set_deviation_heading(0.08f);
    mate.set_sent_ns(ns(moment, moment.t));
    mate.set_received_ns(ns(moment, moment.t));
    mate.set_active(true);
    if (!ball) continue;
    const Point seen = relative(ball->position, robot.position, robot.heading);
    mate.mutable_ball()->set_seen_ns(ns(moment, moment.t));
    mate.mutable_ball()->set_x(narrow(seen.x));
    mate.mutable_ball()->set_y(narrow(seen.y));
    mate.mutable_ball()->set_deviation(narrow(0.05 + 0.05 * std::hypot(seen.x, seen.y)));
    mate.set_time_to_ball(narrow(std::hypot(seen.x, seen.y) / 0.25));
  }
  if (ball) {
    pb::SharedBall& shared = *team.mutable_shared_ball();
    shared.set_seen_ns(ns(moment, moment.t));
    shared.set_x(narrow(ball->position.x + 0.05 * std::sin(moment.t)));
    shared.set_y(narrow(ball->position.y + 0.05 * std::cos(moment.t)));
    shared.set_deviation(0.15f);
    for (const std::uint32_t player : {1u, 2u, 3u}) shared.add_players(player);
  }
  team.set_sent_ns(ns(moment, moment.t));
  team.set_messages_sent(static_cast<std::uint32_t>(moment.t));
  return team;
}

pb::GameState game_of(const SyntheticMoment& moment) {
  const double t = moment.t;
  const bool scored = t >= kGoal;
  pb::GameState game;
  game.set_source(pb::GameState::SOURCE_GAME_CONTROLLER);
  game.set_packet_version(18);
  game.set_packet_number(static_cast<std::uint32_t>(2 * t) % 256);
  game.set_received_ns(ns(moment, t));
  game.set_own_team(14);
  game.set_own_player(2);
  game.set_state(state_at(t));
  game.set_phase(pb::GameState::PHASE_NORMAL);
  game.set_half(1);
  game.set_seconds_remaining(narrow(600 - std::clamp(t - kPlaying, 0.0, kGoal - kPlaying)));
  const double ready_since = scored ? kGoal : kReady;
  if (game.state() == pb::GameState::STATE_READY) game.set_secondary_seconds(narrow(45 - (t - ready_since)));
  game.set_kicking_team(scored ? 5 : 14);
  game.set_players_per_team(3);
  game.set_attacks_positive_x(true);
  fill_team(14, pb::TeamState::COLOUR_RED, scored ? 1 : 0, t, *game.mutable_own());
  fill_team(5, pb::TeamState::COLOUR_BLUE, 0, t, *game.mutable_opponent());
  return game;
}

pb::DecisionTrace decision_of(const SyntheticMoment& moment, const std::optional<pb::Ball>& ball) {
  pb::DecisionTrace trace;
  trace.set_strategy("synthetic");
  trace.set_role("striker");

  const int state = state_at(moment.t);
  if (!ask(trace, "is_playing", "game_state = 5", "game_state", state, 5, state == pb::GameState::STATE_PLAYING)) {
    choose(trace, state == pb::GameState::STATE_READY ? "walk_to_position" : "stand");
    return trace;
  }
  const auto age =
      ball ? std::optional(moment.t - static_cast<double>(ball->seen_ns() - moment.epoch_ns) * 1e-9) : std::nullopt;
  if (!ask(trace, "knows_ball", "ball_age < 3", "ball_age", age, 3, age && *age < 3)) {
    choose(trace, "search_ball");
    return trace;
  }
  const double distance = std::hypot(ball->x(), ball->y());
  const bool near = distance < kKickReach && ball->x() > 0;
  ask(trace, "ball_at_foot", "ball_distance < 0.28", "ball_distance", distance, kKickReach, near);
  choose(trace, near ? "kick" : "approach_ball");
  pb::DecisionTrace::Argument& argument = *trace.add_arguments();
  argument.set_name(near ? "direction" : "distance");
  argument.set_value(narrow(near ? 0.09 : distance));
  return trace;
}

pb::MotionCommand motion_command_of(const SyntheticMoment& moment) {
  const Walker walker = walker_at(moment.t);
  const Bearing bearing = bearing_at(moment.t);
  pb::MotionCommand command;
  if (std::abs(moment.t - kKick) < 0.2) {
    command.mutable_kick()->set_type("walk_forward");
    command.mutable_kick()->set_leg(pb::Kick::LEG_RIGHT);
    command.mutable_kick()->set_in_walk(true);
    command.mutable_kick()->set_direction(0.09f);
  } else if (walker.speed > 0) {
    command.mutable_walk_speed()->set_x(narrow(walker.speed));
    command.mutable_walk_speed()->set_turn_rate(narrow(walker.turn_rate));
  } else {
    command.set_posture(pb::MotionCommand::POSTURE_STAND);
  }
  command.mutable_head_angles()->set_yaw(narrow(bearing.head_yaw));
  command.mutable_head_angles()->set_pitch(narrow(bearing.head_pitch));
  return command;
}

pb::GroundTruth truth_of(const SyntheticMoment& moment) {
  pb::GroundTruth truth;
  if (const auto ball = ball_at(moment.t)) {
    truth.mutable_ball()->set_x(narrow(ball->position.x));
    truth.mutable_ball()->set_y(narrow(ball->position.y));
    truth.mutable_ball()->set_velocity_x(narrow(ball->velocity.x));
    truth.mutable_ball()->set_velocity_y(narrow(ball->velocity.y));
  }
  const auto add = [&](int team, int player, Point position, double heading) {
    pb::GroundTruth::TrueRobot& robot = *truth.add_robots();
    robot.set_team(static_cast<std::uint32_t>(team));
    robot.set_player(static_cast<std::uint32_t>(player));
    robot.set_x(narrow(position.x));
    robot.set_y(narrow(position.y));
    robot.set_heading(narrow(heading));
    robot.set_fallen(false);
  };
  const Walker walker = walker_at(moment.t);
  add(14, 2, walker.position, walker.heading);
  for (const OtherRobot& other : others_at(moment.t)) add(other.team, other.player, other.position, other.heading);
  return truth;
}

}  // namespace robot::lab::synthetic
