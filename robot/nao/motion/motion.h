// Conversion of motion commands into orders for the guardian.
#pragma once

#include <optional>
#include <string>

#include "proto/foresight/game.pb.h"
#include "proto/foresight/motion.pb.h"
#include "robot/nao/guardian/link.h"
#include "robot/nao/model/kinematics.h"
#include "robot/nao/motion/walking_legs.h"

namespace robot::nao {

namespace pb = foresight;

/// The motions of the body `nao`: it walks, kicks with a step, turns the head, stands, sits, freezes, softens and gets up.
/// It has no kicks on one leg: it stands instead, and refused() says so. Pure; used by one thread.
///
/// A kick ahead walks into its ball: the robot goes on until the foot reaches the ball by the odometry, and kicks with the next
/// step of that foot. A kick without a place of the ball takes the next step of its foot.
/// A robot that lies gets up, as the body `sim` does, unless its newest command is to sit, freeze or relax.
/// The first command to walk gives the legs to the walk. From then on a standing robot that is pushed makes steps.
class Motion {
 public:
  static constexpr std::uint64_t kCommandLasts_ns = 1'000'000'000;  // age of a command after which the body stands
  static constexpr float kHeadSpeed = 3;                            // [rad/s] if the command has no speed
  static constexpr float kHeadStiffness = 0.6f;                     // [0..1]

  explicit Motion(Kinematics kinematics = Kinematics(), const walk::Parameters& parameters = {})
      : kinematics_(kinematics), legs_(parameters) {}

  /// Returns the order for the cycle after `report`. `command` is the newest one, `command_age_ns` old, or null before
  /// the first. `game` is the GameController's state, or null without one.
  Order next(const Report& report, const pb::MotionCommand* command, std::uint64_t command_age_ns,
             const pb::GameState* game);

  /// Walks with other parameters, see Walk::change().
  void change_walk(const walk::Parameters& parameters) { legs_.change(parameters); }

  /// Returns one sentence if the command asks for a motion that this body does not have, else an empty string.
  const std::string& refused() const { return refused_; }

  /// Reports whether the present step kicks.
  bool kicks() const { return legs_.kicks(); }

  /// Reports whether there is odometry: since the first command to walk.
  bool has_odometry() const { return may_walk_; }
  /// Fills the odometry of the walk.
  void fill_odometry(pb::Odometry& odometry) const;

  /// Fills the status of the body, the walk and the head.
  void fill_status(const Report& report, pb::MotionStatus& status) const;

 private:
  struct HeadTarget {
    float yaw = 0, pitch = 0;                                // [rad] within the range of the head
    float yaw_speed = kHeadSpeed, pitch_speed = kHeadSpeed;  // [rad/s]
  };

  /// A ball, from where the robot was when it heard of it.
  struct KickedBall {
    walk::Point place;  // [m, robot]
    walk::Way from;
  };

  /// The state of the commanded kick: it waits for a step of its foot, or that step has begun.
  enum class Kicking { no, waits, begun };

  Order::Posture posture_of(const pb::MotionCommand& command) const;
  void take_walk(const pb::MotionCommand& command);
  void take_kick(const pb::Kick& kick);
  walk::Command kick_step(const Report& report) const;
  void aim(const Report& report, const pb::MotionCommand& command);
  HeadTarget look_to(const Report& report, const pb::LookTo& place) const;

  const Kinematics kinematics_;
  WalkingLegs legs_;
  bool may_walk_ = false;  // a command to walk has come
  walk::Command walk_;
  pb::Kick kick_;  // the commanded kick
  Kicking kicking_ = Kicking::no;
  float kick_age_ = 0;              // [s] since it was commanded, or since its step ended
  std::optional<KickedBall> ball_;  // of that kick; nothing: the command does not say
  std::optional<HeadTarget> head_;  // nothing: no command for the head yet
  Order::Posture posture_ = Order::Posture::stand;
  std::string refused_;
  std::uint64_t last_capture_ns_ = 0;
};

/// Returns the GameController's data about this robot, from `game`.
GameWord word_of(const pb::GameState& game);

}  // namespace robot::nao
