#include "robot/bridge/to_messages.h"

#include <algorithm>
#include <cmath>

#include "sim/agent/roles.h"
#include "sim/math/vec2.h"
#include "sim/referee/referee.h"

namespace robot::bridge {
namespace {

using sim::Vec2;
using Doing = sim::Body::Doing;

/// Computes where the ball crosses the robot's y axis on its way to the robot. Returns false if it stops before.
bool crosses(Vec2 position, Vec2 velocity, Vec2 rest, float& y) {
  if (velocity.x >= 0 || position.x <= 0 || rest.x > 0) return false;
  y = position.y - position.x * velocity.y / velocity.x;
  return true;
}

pb::GameState::State state_of(sim::agent::Game::Phase phase) {
  using enum sim::agent::Game::Phase;
  switch (phase) {
    case initial: return pb::GameState::STATE_INITIAL;
    case ready: return pb::GameState::STATE_READY;
    case set: return pb::GameState::STATE_SET;
    case playing: return pb::GameState::STATE_PLAYING;
    case finished: return pb::GameState::STATE_FINISHED;
  }
  return pb::GameState::STATE_UNSPECIFIED;
}

/// The GameController does not count a kick-off as a set play.
pb::GameState::SetPlay set_play_of(sim::agent::Game::SetPlay set_play) {
  using enum sim::agent::Game::SetPlay;
  switch (set_play) {
    case none:
    case kick_off: return pb::GameState::SET_PLAY_UNSPECIFIED;
    case kick_in: return pb::GameState::SET_PLAY_KICK_IN;
    case goal_kick: return pb::GameState::SET_PLAY_GOAL_KICK;
    case corner_kick: return pb::GameState::SET_PLAY_CORNER_KICK;
  }
  return pb::GameState::SET_PLAY_UNSPECIFIED;
}

void fill_team(const sim::Params& params, const sim::State& state, sim::Side side, std::uint32_t number, int score,
               pb::TeamState& team) {
  const bool home = side == sim::Side::home;
  team.set_number(number);
  team.set_field_colour(home ? pb::TeamState::COLOUR_BLUE : pb::TeamState::COLOUR_RED);
  team.set_goalkeeper_colour(home ? pb::TeamState::COLOUR_GREEN : pb::TeamState::COLOUR_YELLOW);
  team.set_goalkeeper(1);
  team.set_score(static_cast<std::uint32_t>(score));
  if (params.rules.message_budget > 0) {
    const int left = params.rules.message_budget - state.book.packets[static_cast<int>(side)];
    team.set_message_budget(static_cast<std::uint32_t>(std::max(left, 0)));
  }
  for (int player = 1; player <= state.world.players; ++player) {
    const sim::Tick until = state.book.penalised_until[sim::robot_of(side, player)];
    pb::PlayerState& told = *team.add_players();
    told.set_penalised(until != 0);
    if (until > state.world.tick) told.set_seconds_till_unpenalised(sim::age(until, state.world.tick));
  }
}

void fill_body(const sim::motion::Command& command, const sim::motion::Model& model, pb::MotionCommand& message) {
  using enum sim::motion::Command::Body;
  switch (command.body) {
    case stand: message.set_posture(pb::MotionCommand::POSTURE_STAND); break;
    case squat: message.mutable_scripted()->set_name("squat"); break;
    case walk_speed:
      message.mutable_walk_speed()->set_x(command.walk.x);
      message.mutable_walk_speed()->set_y(command.walk.y);
      message.mutable_walk_speed()->set_turn_rate(command.turn);
      break;
    case walk_to:
      message.mutable_walk_to()->set_x(command.walk.x);
      message.mutable_walk_to()->set_y(command.walk.y);
      message.mutable_walk_to()->set_heading(command.turn);
      message.mutable_walk_to()->set_gain(command.gain);
      break;
    case kick:
      const sim::motion::Kick& kind = model.kicks[command.kick];
      message.mutable_kick()->set_type(kind.name);
      message.mutable_kick()->set_leg(command.kick_left ? pb::Kick::LEG_LEFT : pb::Kick::LEG_RIGHT);
      message.mutable_kick()->set_direction(command.kick_left ? kind.direction : -kind.direction);
      message.mutable_kick()->set_in_walk(kind.in_walk);
      message.mutable_kick()->set_distance(command.gain * kind.range);
      break;
  }
}

void fill_head(const sim::motion::Command& command, pb::MotionCommand& message) {
  using enum sim::motion::Command::Head;
  switch (command.head) {
    case keep: break;
    case angles:
      message.mutable_head_angles()->set_yaw(command.look[0]);
      message.mutable_head_angles()->set_pitch(command.look[1]);
      break;
    case look_to:
      message.mutable_look_to()->set_x(command.look[0]);
      message.mutable_look_to()->set_y(command.look[1]);
      message.mutable_look_to()->set_z(command.look[2]);
      break;
  }
}

pb::MotionStatus::Fall fall_of(Doing doing) {
  if (doing == Doing::fallen) return pb::MotionStatus::FALL_FALLEN;
  return doing == Doing::getting_up ? pb::MotionStatus::FALL_GETTING_UP : pb::MotionStatus::FALL_UPRIGHT;
}

pb::MotionStatus::FallSide fall_side_of(sim::Lying lying) {
  switch (lying) {
    case sim::Lying::on_back: return pb::MotionStatus::FALL_SIDE_BACK;
    case sim::Lying::on_front: return pb::MotionStatus::FALL_SIDE_FRONT;
    case sim::Lying::on_left: return pb::MotionStatus::FALL_SIDE_LEFT;
    case sim::Lying::on_right: return pb::MotionStatus::FALL_SIDE_RIGHT;
  }
  return pb::MotionStatus::FALL_SIDE_UNSPECIFIED;
}

/// Fills the ball of a teammate's message, in the frame of that teammate's robot.
void fill_told_ball(const sim::agent::Mate& mate, const Timeline& timeline, pb::Ball& ball) {
  const Vec2 in_robot = sim::turned_back(mate.ball - mate.pose.position, sim::direction(mate.pose.heading));
  ball.set_x(in_robot.x);
  ball.set_y(in_robot.y);
  ball.set_seen_ns(timeline.at(mate.sent - std::min<sim::Tick>(mate.ball_age, mate.sent)));
  ball.set_visible(mate.ball_age == 0);
}

}  // namespace

std::string robot_name(const TeamNumbers& teams, int robot) {
  return std::to_string(teams.of(sim::side_of(robot))) + "/" + std::to_string(sim::player_of(robot));
}

bool to_proto(const sim::agent::Ball& ball, float deceleration, const Timeline& timeline, pb::Ball& message) {
  message.Clear();
  if (ball.seen == sim::kNever) return false;
  message.set_seen_ns(timeline.at(ball.seen));
  message.set_x(ball.position.x);
  message.set_y(ball.position.y);
  message.set_velocity_x(ball.velocity.x);
  message.set_velocity_y(ball.velocity.y);
  message.set_deviation(std::sqrt(ball.variance));
  message.set_visible(ball.visible);
  message.set_heat(ball.heat);
  message.set_velocity_deviation(std::sqrt(ball.velocity_variance));
  message.set_covariance_xx(ball.variance);
  message.set_covariance_xy(0);
  message.set_covariance_yy(ball.variance);

  // only the turf slows it: it rolls v²/2a further
  const float speed = sim::length(ball.velocity);
  const Vec2 slowing = speed > 0 ? (-deceleration / speed) * ball.velocity : Vec2{};
  const Vec2 rest = ball.position + (speed / (2 * deceleration)) * ball.velocity;
  message.set_acceleration_x(slowing.x);
  message.set_acceleration_y(slowing.y);
  message.set_rest_x(rest.x);
  message.set_rest_y(rest.y);
  if (float y = 0; crosses(ball.position, ball.velocity, rest, y)) message.set_crossing_y(y);

  if (ball.visible)
    message.set_frames_visible(ball.frames);
  else
    message.set_frames_missing(ball.frames);
  return true;
}

void to_proto(const sim::field::Field& field, pb::Field& message) {
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

void to_proto(const sim::agent::Pose& pose, pb::Pose& message) {
  message.Clear();
  message.set_x(pose.pose.position.x);
  message.set_y(pose.pose.position.y);
  message.set_heading(pose.pose.heading);
  message.set_deviation_x(pose.deviation);
  message.set_deviation_y(pose.deviation);
  message.set_deviation_heading(pose.deviation_heading);
}

void to_proto(const sim::agent::Beliefs& beliefs, int player, const Timeline& timeline, pb::Team& message) {
  message.Clear();
  for (int i = 0; i < sim::agent::kMaxMates; ++i) {
    const sim::agent::Mate& mate = beliefs.mates[i];
    if (mate.sent == sim::kNever) continue;
    pb::Teammate& told = *message.add_teammates();
    // of player 3, mates[2] is player 4
    told.set_player(static_cast<std::uint32_t>(i + 1 < player ? i + 1 : i + 2));
    told.set_role(sim::agent::name_of(static_cast<sim::agent::Role>(mate.role)));
    told.mutable_pose()->set_x(mate.pose.position.x);
    told.mutable_pose()->set_y(mate.pose.position.y);
    told.mutable_pose()->set_heading(mate.pose.heading);
    if (mate.ball_age != 0xffff) fill_told_ball(mate, timeline, *told.mutable_ball());
    told.set_sent_ns(timeline.at(mate.sent));
    told.set_received_ns(timeline.at(mate.sent));
    told.set_active(mate.active);
    told.set_time_to_ball(mate.time_to_ball());
    if (mate.choice.strategy == sim::agent::kNoStrategy) continue;
    told.set_strategy(mate.choice.strategy);
    told.set_epoch(mate.choice.epoch);
  }
}

void to_proto(const sim::agent::Beliefs& beliefs, const Timeline& timeline, pb::Opponents& message) {
  message.Clear();
  for (int i = 0; i < sim::kMaxPlayers; ++i) {
    const sim::agent::Opponent& opponent = beliefs.opponents[i];
    if (opponent.seen == sim::kNever) continue;
    pb::Opponents::Opponent& told = *message.add_opponents();
    told.set_player(static_cast<std::uint32_t>(i + 1));
    told.set_x(opponent.position.x);
    told.set_y(opponent.position.y);
    told.set_seen_ns(timeline.at(opponent.seen));
  }
}

void to_proto(const sim::Params& params, const sim::State& state, int robot, const TeamNumbers& teams,
              const Timeline& timeline, pb::GameState& message) {
  message.Clear();
  const sim::agent::Game game = sim::referee::game_for(params.rules, state.world, state.book, robot);
  const sim::Side side = sim::side_of(robot);
  message.set_source(pb::GameState::SOURCE_SIMULATOR);
  message.set_received_ns(timeline.at(state.world.tick));
  message.set_own_team(teams.of(side));
  message.set_own_player(static_cast<std::uint32_t>(sim::player_of(robot)));
  message.set_state(state_of(game.phase));
  message.set_set_play(set_play_of(game.set_play));
  message.set_phase(pb::GameState::PHASE_NORMAL);
  message.set_half(game.half);
  message.set_seconds_remaining(game.remaining);
  const float countdown = sim::referee::countdown_of(params.rules, game.phase, game.set_play);
  message.set_secondary_seconds(std::max(countdown - game.since_phase, 0.f));
  if (game.set_play != sim::agent::Game::SetPlay::none)
    message.set_kicking_team(teams.of(game.own_kick ? side : sim::other(side)));
  message.set_players_per_team(game.players);
  message.set_attacks_positive_x(sim::attack_sign(state.world, side) > 0);
  fill_team(params, state, side, teams.of(side), game.own_score, *message.mutable_own());
  fill_team(params, state, sim::other(side), teams.of(sim::other(side)), game.opponent_score,
            *message.mutable_opponent());
}

void to_proto(const sim::motion::Command& command, const sim::motion::Model& model, pb::MotionCommand& message) {
  message.Clear();
  fill_body(command, model, message);
  fill_head(command, message);
}

void to_proto(const sim::Body& body, const sim::motion::Command& command, const sim::motion::Model& model,
              sim::Tick now, pb::MotionStatus& message) {
  message.Clear();
  const Doing doing = body.doing;
  const bool walks = doing == Doing::starting || doing == Doing::walking || doing == Doing::stopping;
  const bool rests = doing == Doing::standing || doing == Doing::fallen || doing == Doing::removed;
  message.set_body_active(!rests);
  message.set_head_active(command.head != sim::motion::Command::Head::keep);
  message.set_walking(walks);
  message.set_standing(doing == Doing::standing);
  message.set_stopping(doing == Doing::stopping);
  message.set_calibrated(true);
  message.set_fall(fall_of(doing));
  // without a table of falls nobody knows the side
  if (sim::lies(body) && model.falls.table.given) message.set_fall_side(fall_side_of(sim::Lying{body.kind}));
  message.set_ground_contact(doing != Doing::removed);
  message.set_velocity_x(body.velocity.x);
  message.set_velocity_y(body.velocity.y);
  message.set_turn_rate(body.turn_rate);
  if (doing == Doing::kicking) {
    const sim::motion::Kick& kick = model.kicks[body.kind];
    message.set_running(kick.name);
    message.set_remaining(std::max(kick.duration - sim::age(now, body.since), 0.f));
  }
  if (doing == Doing::crouching || doing == Doing::squatting) {
    message.set_running("squat");
    message.set_remaining(std::max(model.squat.duration - sim::age(now, body.since), 0.f));
  }
  if (walks && command.body == sim::motion::Command::Body::walk_to) {
    message.mutable_target()->set_x(command.walk.x);
    message.mutable_target()->set_y(command.walk.y);
    message.mutable_target()->set_heading(command.turn);
    message.mutable_target()->set_gain(command.gain);
  }
}

void to_proto(const sim::agent::Trace& trace, pb::DecisionTrace& message) {
  message.Clear();
  message.set_strategy(trace.strategy);
  message.set_role(trace.role);
  message.set_skill(trace.skill);
  for (const sim::agent::Trace::Node& visited : trace.visited) {
    pb::DecisionTrace::Node& node = *message.add_visited();
    const bool asks = *visited.condition != '\0';
    node.set_kind(asks ? pb::DecisionTrace::Node::KIND_CONDITION : pb::DecisionTrace::Node::KIND_SKILL);
    node.set_name(visited.name);
    node.set_path(visited.path);
    node.set_condition(visited.condition);
    node.set_feature(visited.feature);
    if (asks && !std::isnan(visited.threshold)) node.set_threshold(visited.threshold);
    if (asks && visited.known) node.set_value(visited.value);
    node.set_result(visited.result);
  }
  for (const sim::agent::Trace::Argument& argument : trace.arguments) {
    pb::DecisionTrace::Argument& said = *message.add_arguments();
    said.set_name(argument.name);
    said.set_value(argument.value);
  }
}

void to_proto(const sim::World& world, const TeamNumbers& teams, pb::GroundTruth& message) {
  message.Clear();
  message.mutable_ball()->set_x(world.ball.position.x);
  message.mutable_ball()->set_y(world.ball.position.y);
  message.mutable_ball()->set_velocity_x(world.ball.velocity.x);
  message.mutable_ball()->set_velocity_y(world.ball.velocity.y);
  sim::for_each_robot(world.players, [&](int robot) {
    const sim::Body& body = world.bodies[robot];
    if (!on_field(body)) return;
    pb::GroundTruth::TrueRobot& seen = *message.add_robots();
    seen.set_team(teams.of(sim::side_of(robot)));
    seen.set_player(static_cast<std::uint32_t>(sim::player_of(robot)));
    seen.set_x(body.position.x);
    seen.set_y(body.position.y);
    seen.set_heading(body.heading);
    seen.set_fallen(sim::lies(body));
  });
}

}  // namespace robot::bridge
