// The walk's connection to the body: reports of the guardian in, joints of an order out.
#pragma once

#include <optional>

#include "proto/foresight/motion.pb.h"
#include "robot/nao/guardian/link.h"
#include "robot/nao/walk/destination.h"
#include "robot/nao/walk/odometry.h"
#include "robot/nao/walk/walk.h"

namespace robot::nao {

/// The legs of a robot that stands, ready to walk. They move from the guardian's stand to that of the walk, and then
/// obey it. Pure; used by one thread.
class WalkingLegs {
 public:
  explicit WalkingLegs(const walk::Parameters& parameters = {}) : parameters_(parameters) {}

  static constexpr float kTakeOver = 0.6f;   // [s] from the guardian's stand to that of the walk
  static constexpr float kStiffness = 0.9f;  // [0..1] of the legs

  /// Drives the legs in `order`, the one after `report`, `dt` [s] after the last. Drives nothing and forgets everything
  /// unless the body stands in the mode playing.
  void drive(const Report& report, const walk::Command& command, float dt, Order& order);

  /// Walks with other parameters, see Walk::change().
  void change(const walk::Parameters& parameters);

  /// Reports whether the robot makes steps.
  bool steps() const { return walk_ && walk_->steps(); }

  const walk::Parameters& parameters() const { return parameters_; }

  /// Returns the share of the commanded speed that the robot walks with: a warm one has half.
  static double share_of_speed(const Report& report) { return report.limited ? 0.5 : 1; }

  /// Returns the planned speed ahead of the present step [m/s].
  double speed_ahead() const { return walk_ ? walk_->speed().forward : 0; }

  /// Reports whether the present step kicks.
  bool kicks() const { return walk_ && walk_->kick() != walk::KickStep::none; }

  /// Returns the way since the robot first walked. It is never reset.
  const walk::Way& way() const { return odometry_.way(); }

  /// Fills the fields about walking. The others keep their values.
  void fill_status(foresight::MotionStatus& status) const;

 private:
  bool take_over(const Report& report, float dt);

  walk::Parameters parameters_;
  std::optional<walk::Walk> walk_;  // nothing: the legs belong to the guardian
  walk::Odometry odometry_;
  walk::Legs from_{}, targets_{};
  float taken_ = 0;  // [s] since the beginning of the take-over
  bool stops_ = false;
};

/// Returns the sensors of a report as the walk needs them. All values of a report are finite.
walk::Sensors walking_sensors(const Report& report);

}  // namespace robot::nao
