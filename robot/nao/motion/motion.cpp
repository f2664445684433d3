#include "robot/nao/motion/motion.h"

#include <algorithm>
#include <cmath>
#include <tuple>

#include "robot/nao/motion/messages.h"

namespace robot::nao {
namespace {

constexpr float kLongestStep = 0.1f;  // [s] longest step of the head after a gap
constexpr float kSideways = 0.6f;     // [rad] kicks in a direction farther off are not forward
constexpr float kKickWaits = 1;       // [s] a kick that has found no step of its foot by then is given up
constexpr float kKicksAgain = 0.5f;   // [s] after a kick that has ended and is still commanded: it has missed
constexpr double kBallAside = 0.06;   // [m] of the ball before its foot
constexpr double kBesideFoot = 0.05;  // [m] a ball farther aside is not in front of the foot
constexpr double kNearest = 0.05;     // [m] from the robot to a ball that is still before the feet
constexpr double kInGait = 0.85;      // [kick_speed] a slower step does not kick
constexpr double kSidesteps = 1.5;    // [1/s] speed per distance
constexpr float kArrived = 0.03f;     // [rad] largest error of a head that has arrived

float towards(float from, float to, float step) { return from + clamp(to - from, {-step, step}); }

/// Returns the commanded speed, limited to the joint's speed, or kHeadSpeed if no positive speed was given.
float speed_of(bool given, float speed, std::size_t joint) {
  return given && speed > 0 ? std::min(speed, limits_of(joint).speed) : Motion::kHeadSpeed;
}

/// Returns why the body cannot do this, or "" if it can.
std::string refusal_of(const pb::MotionCommand& command) {
  if (command.has_kick() && !command.kick().in_walk())
    return "body nao kicks only with a step of the walk (in_walk): it stands";
  if (command.has_scripted())
    return "body nao has no motion '" + command.scripted().name().substr(0, 40) + "': it stands";
  return "";
}

}  // namespace

GameWord word_of(const pb::GameState& game) {
  GameWord word;
  word.heard = game.received_ns() != 0 ? 1 : 0;
  word.player = static_cast<std::uint8_t>(std::min<std::uint32_t>(game.own_player(), 255));
  const int index = static_cast<int>(game.own_player()) - 1;
  if (game.has_own() && index >= 0 && index < game.own().players_size())
    word.penalised = game.own().players(index).penalised() ? 1 : 0;
  switch (game.state()) {
    case pb::GameState::STATE_INITIAL: word.state = GameState::initial; break;
    case pb::GameState::STATE_STANDBY: word.state = GameState::standby; break;
    case pb::GameState::STATE_READY: word.state = GameState::ready; break;
    case pb::GameState::STATE_SET: word.state = GameState::set; break;
    case pb::GameState::STATE_PLAYING: word.state = GameState::playing; break;
    case pb::GameState::STATE_FINISHED: word.state = GameState::finished; break;
    default: break;
  }
  return word;
}

Order Motion::next(const Report& report, const pb::MotionCommand* command, std::uint64_t command_age_ns,
                   const pb::GameState* game) {
  const float dt = std::min(static_cast<float>(report.capture_ns - last_capture_ns_) * 1e-9f, kLongestStep);
  last_capture_ns_ = report.capture_ns;
  Order order;
  if (game) order.game = word_of(*game);
  refused_.clear();
  kick_age_ += dt;
  const bool obeys = command && command_age_ns <= kCommandLasts_ns;
  if (!obeys) {
    posture_ = Order::Posture::stand;
    walk_ = {};
  } else {
    refused_ = refusal_of(*command);
    posture_ = posture_of(*command);
    take_walk(*command);
    if (kicking_ == Kicking::waits) walk_ = kick_step(report);
    aim(report, *command);
  }
  // a walking robot stands before it sits or holds still: a foot may be in the air
  const bool stops = posture_ != Order::Posture::soft && legs_.steps();
  order.posture = stops ? Order::Posture::stand : posture_;
  const bool down = report.doing == Doing::fallen || report.doing == Doing::getting_up;
  if (down && obeys && posture_ == Order::Posture::stand) order.posture = Order::Posture::get_up;
  if (may_walk_) legs_.drive(report, walk_, dt, order);
  if (legs_.kicks()) {
    kicking_ = Kicking::begun;
    kick_age_ = 0;
    walk_ = {};
  }
  if (!head_) return order;
  for (const auto& [joint, target, speed] :
       {std::tuple{head_yaw, head_->yaw, head_->yaw_speed}, {head_pitch, head_->pitch, head_->pitch_speed}}) {
    order.drives[joint] = 1;
    order.position[joint] = towards(report.commanded[joint], target, speed * dt);
    order.stiffness[joint] = kHeadStiffness;
  }
  return order;
}

Order::Posture Motion::posture_of(const pb::MotionCommand& command) const {
  if (command.body_case() == pb::MotionCommand::BODY_NOT_SET) return posture_;
  if (!command.has_posture()) return Order::Posture::stand;
  switch (command.posture()) {
    case pb::MotionCommand::POSTURE_SIT: return Order::Posture::sit;
    case pb::MotionCommand::POSTURE_FREEZE: return Order::Posture::freeze;
    case pb::MotionCommand::POSTURE_RELAX: return Order::Posture::soft;
    default: return Order::Posture::stand;
  }
}

/// Takes the walk of a command. A command without a body part lets the walk go on; values that are no numbers stop it.
/// A kick waits for the step of its foot. Until then commands to walk do not take it back: a behaviour may change its
/// mind with each image.
void Motion::take_walk(const pb::MotionCommand& command) {
  if (command.body_case() == pb::MotionCommand::BODY_NOT_SET) return;
  const bool walks = command.has_walk_speed() || command.has_walk_to();
  if (walks && kicking_ == Kicking::waits && kick_age_ < kKickWaits) return;
  walk_ = {};
  if (command.has_kick() && command.kick().in_walk()) return take_kick(command.kick());
  kicking_ = Kicking::no;
  const walk::Limits limits;
  if (command.has_walk_speed()) {
    const pb::WalkSpeed& speed = command.walk_speed();
    if (!std::isfinite(speed.x()) || !std::isfinite(speed.y()) || !std::isfinite(speed.turn_rate())) return;
    walk_ = within(limits, {speed.x(), speed.y(), speed.turn_rate()});
  } else if (command.has_walk_to()) {
    const pb::WalkTo& to = command.walk_to();
    if (!std::isfinite(to.x()) || !std::isfinite(to.y()) || !std::isfinite(to.heading()) || !std::isfinite(to.gain()))
      return;
    walk_ = towards({to.x(), to.y(), to.heading()}, to.gain(), limits);
  }
  may_walk_ |= !walk_.stands();
}

/// Takes a kick. One that is commanded still when its step has long ended has missed; it is kicked again if the command says
/// where the ball is.
void Motion::take_kick(const pb::Kick& kick) {
  const bool has_ball = kick.has_ball_x() && kick.has_ball_y();
  const bool again = kicking_ == Kicking::begun && has_ball && kick_age_ > kKicksAgain;
  if (kicking_ == Kicking::no) ball_.reset();
  if (kicking_ == Kicking::no || again) kicking_ = Kicking::waits, kick_age_ = 0;
  if (kicking_ != Kicking::waits) return;
  may_walk_ = true;
  // the same command comes many times, but the robot walks on
  const bool moved = !ball_ || kick.ball_x() != kick_.ball_x() || kick.ball_y() != kick_.ball_y();
  if (has_ball && moved) ball_ = {{kick.ball_x(), kick.ball_y(), 0}, legs_.way()};
  kick_ = kick;
}

/// Returns the walk until the step that kicks, and that step: with the foot nearer to the ball, outwards for a direction to
/// the side of that foot. The robot walks to a ball that the foot does not reach yet, and stands before one it has passed.
walk::Command Motion::kick_step(const Report& report) const {
  walk::Command command;
  const bool is_left = kick_.leg() == pb::Kick::LEG_LEFT || (kick_.leg() != pb::Kick::LEG_RIGHT && kick_.ball_y() > 0);
  command.foot = is_left ? walk::left : walk::right;
  const float outwards = is_left ? kick_.direction() : -kick_.direction();
  command.kick = outwards > kSideways    ? walk::KickStep::side
                 : outwards < -kSideways ? walk::KickStep::turn
                                         : walk::KickStep::forward;
  if (command.kick != walk::KickStep::forward) return command;
  command.forward = legs_.parameters().kick_speed;
  if (!ball_) return command;
  const walk::Point ball = walk::passed(ball_->from, ball_->place, legs_.way());
  const double aside = ball.y - walk::sign_of(command.foot) * kBallAside;
  if (!std::isfinite(ball.x) || !std::isfinite(ball.y) || ball.x < kNearest) return {};
  command.left = walk::within(walk::Limits{}, {.left = kSidesteps * aside}).left;
  const bool reaches = ball.x < legs_.parameters().kick_reach && std::abs(aside) < kBesideFoot;
  const bool in_gait = legs_.speed_ahead() > kInGait * WalkingLegs::share_of_speed(report) * command.forward;
  if (!reaches || !in_gait) command.kick = walk::KickStep::none;
  return command;
}

void Motion::aim(const Report& report, const pb::MotionCommand& command) {
  HeadTarget target;
  if (command.has_look_to()) {
    target = look_to(report, command.look_to());
    target.yaw_speed = speed_of(command.look_to().has_max_yaw_speed(), command.look_to().max_yaw_speed(), head_yaw);
    target.pitch_speed =
        speed_of(command.look_to().has_max_pitch_speed(), command.look_to().max_pitch_speed(), head_pitch);
  } else if (command.has_head_angles()) {
    const pb::HeadAngles& angles = command.head_angles();
    target.yaw = angles.yaw();
    target.pitch = angles.pitch();
    target.yaw_speed = speed_of(angles.has_max_yaw_speed(), angles.max_yaw_speed(), head_yaw);
    target.pitch_speed = speed_of(angles.has_max_pitch_speed(), angles.max_pitch_speed(), head_pitch);
  } else {
    return;
  }
  if (!std::isfinite(target.yaw) || !std::isfinite(target.pitch)) return;
  target.yaw = clamp(target.yaw, limits_of(head_yaw).range);
  target.pitch = clamp(target.pitch, head_pitch_range(target.yaw));
  head_ = target;
}

/// Uses the upper camera, or the lower one if the head cannot be lowered far enough.
Motion::HeadTarget Motion::look_to(const Report& report, const pb::LookTo& place) const {
  const Transform robot =
      kinematics_.robot_from_hip(report.sensors.position, report.sensors.angles[0], report.sensors.angles[1]);
  const Eigen::Vector3d point = robot.inverse() * Eigen::Vector3d(place.x(), place.y(), place.z());
  Kinematics::HeadTurn head = kinematics_.look_at(point, Camera::top);
  if (head.pitch > head_pitch_range(static_cast<float>(head.yaw)).high)
    head = kinematics_.look_at(point, Camera::bottom);
  return {.yaw = static_cast<float>(head.yaw), .pitch = static_cast<float>(head.pitch)};
}

void Motion::fill_odometry(pb::Odometry& odometry) const {
  const walk::Way& way = legs_.way();
  odometry.set_x(static_cast<float>(way.x));
  odometry.set_y(static_cast<float>(way.y));
  odometry.set_heading(static_cast<float>(way.heading));
}

void Motion::fill_status(const Report& report, pb::MotionStatus& status) const {
  fill(report, status);
  legs_.fill_status(status);
  if (status.walking() && (kicking_ == Kicking::waits || legs_.kicks())) status.set_running(kick_.type());
  const auto away = [&](std::size_t joint, float target) {
    return std::abs(report.sensors.position[joint] - target) > kArrived;
  };
  status.set_head_active(head_ && report.mode == Mode::playing && report.doing == Doing::standing &&
                         (away(head_yaw, head_->yaw) || away(head_pitch, head_->pitch)));
}

}  // namespace robot::nao
