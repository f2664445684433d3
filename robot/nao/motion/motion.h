// From motion commands to what the guardian is asked for.
#pragma once

#include <optional>
#include <string>

#include "proto/foresight/game.pb.h"
#include "proto/foresight/motion.pb.h"
#include "robot/nao/guardian/link.h"
#include "robot/nao/model/kinematics.h"

namespace robot::nao {

namespace pb = foresight;

/// The head goes where it is told, the body stands, sits, freezes and softens. It does not walk, kick or get up from the
/// ground yet: it stands instead, and refused() says so. Pure; used by one thread.
class Motion {
 public:
  static constexpr std::uint64_t kCommandLasts_ns = 1'000'000'000;  // without a newer one the body stands
  static constexpr float kHeadSpeed = 3;                            // [rad/s] unless the command says otherwise
  static constexpr float kHeadStiffness = 0.6f;                     // [0..1]

  explicit Motion(Kinematics kinematics = Kinematics()) : kinematics_(kinematics) {}

  /// The order for the cycle after `report`. `command` is the newest, null if there was none; it is `command_age_ns` old.
  /// `game` is what the GameController said, null if nothing.
  Order next(const Report& report, const pb::MotionCommand* command, std::uint64_t command_age_ns,
             const pb::GameState* game);

  /// One sentence when the command asks for what this body cannot do; else empty.
  const std::string& refused() const { return refused_; }

  /// What the body does, head included.
  void fill_status(const Report& report, pb::MotionStatus& status) const;

 private:
  struct HeadTarget {
    float yaw = 0, pitch = 0;                                // [rad] that the head can reach
    float yaw_speed = kHeadSpeed, pitch_speed = kHeadSpeed;  // [rad/s]
  };

  Order::Posture posture_of(const pb::MotionCommand& command) const;
  void aim(const Report& report, const pb::MotionCommand& command);
  HeadTarget look_to(const Report& report, const pb::LookTo& place) const;

  const Kinematics kinematics_;
  std::optional<HeadTarget> head_;  // nothing: nobody has said anything about the head
  Order::Posture posture_ = Order::Posture::stand;
  std::string refused_;
  std::uint64_t last_capture_ns_ = 0;
};

/// What the GameController said of the robot that `game` is about.
GameWord word_of(const pb::GameState& game);

}  // namespace robot::nao
