// A walk that feels the ground and catches its falls.
//
// The robot walks by lifting its feet in turns, without a commanded sway: the body is a pendulum that falls from one foot
// to the other. The weight on the feet, not a clock, ends each step. The torso's tilt and rates correct the support leg,
// and the swing foot steps to where the body tips. Ideas: Walk2014 of rUNSWift (Hengst), B-Human's documentation of
// their walk, and HULKs' issues. The learned course of the error, the measured lag and sag of the servos and the governor
// are our own.
#pragma once

#include <array>

#include "robot/nao/walk/balance.h"
#include "robot/nao/walk/hip_sag.h"
#include "robot/nao/walk/legs.h"
#include "robot/nao/walk/parameters.h"
#include "robot/nao/walk/sensors.h"
#include "robot/nao/walk/servo_lag.h"

namespace robot::nao::walk {

/// Returns the legs of a robot that stands, ready to walk.
Legs stand(const Parameters& parameters = {});

/// The walk of one robot. Pure: sensors and a command in, angles of the legs out. Allocates nothing. Used by one
/// thread. At 83 Hz (LoLA) or 100 Hz (NAOqi).
class Walk {
 public:
  explicit Walk(const Parameters& parameters = {});
  Walk(const Walk&) = delete;
  Walk& operator=(const Walk&) = delete;

  /// Returns the targets of the legs for the next `dt` [s]. A command of zero ends the walk within a few steps. A
  /// standing robot that is pushed steps until it is steady again. A robot that is lifted stands still.
  const Legs& tick(const Sensors& sensors, const Command& command, double dt);

  /// Walks with other parameters. The present ones go there evenly, within half a second: no leg jumps.
  void change(const Parameters& parameters);
  /// Returns the present parameters.
  const Parameters& parameters() const { return parameters_; }

  /// Reports whether it makes steps.
  bool steps() const { return stepping_; }
  /// Returns the foot that swings, or swung last.
  Side swing() const { return swing_; }
  /// Returns the number of steps since it last stood.
  int count() const { return count_; }
  /// Returns the planned speed of the present step.
  const Command& speed() const { return speed_; }
  /// Returns the kick of the present step.
  KickStep kick() const { return stepping_ ? kick_ : KickStep::none; }
  /// Returns the shift of the swing foot that catches a fall.
  const Tipping& caught() const { return shift_; }

 private:
  /// The place of a foot, relative to its place under the hip [m, torso's heading].
  struct Foot {
    double x = 0, y = 0, z = 0;
    double yaw = 0;  // [rad]
  };

  void approach_wanted(double dt);
  void feel(const Sensors& sensors, double dt);
  void start_if_needed(const Sensors& sensors, const Command& command);
  void end_step(const Sensors& sensors, const Command& command);
  bool may_stand(const Command& command) const;
  void begin_step(const Sensors& sensors, const Command& command);
  void judge_last_step(const Sensors& sensors);
  double heading_turn(const Command& command, const Sensors& sensors, double dt);
  void govern();
  void catch_fall(const Tipping& error, double dt);
  void move_feet();
  void close_feet(double dt);
  HipSag::Weights carried() const;
  void pose(const Sensors& sensors, double dt);
  double period() const { return kick_ == KickStep::none ? parameters_.period : parameters_.kick_period; }
  double phase() const { return time_ / period(); }
  double kick_swing() const;
  double lift() const;

  Parameters parameters_;  // now; the next three refer to them
  Balance balance_;
  ServoLag lag_;
  HipSag sag_;
  Parameters wanted_;
  double change_ = 0;  // [s] until the parameters are the wanted ones

  // the step
  bool stepping_ = false;
  Side swing_ = left;
  int count_ = 0;
  double time_ = 0;      // [s] since its beginning
  double duration_ = 0;  // [s] of the last one
  Command speed_;        // planned
  double stride_ = 0;    // [m] of the present step
  KickStep kick_ = KickStep::none;
  bool ends_ = false;            // steps on the spot until it may stand
  std::array<Foot, 2> feet_{};   // now
  std::array<Foot, 2> start_{};  // at the beginning of the step
  std::array<Foot, 2> end_{};    // at its planned end, without x
  double still_ = 0;             // [s] it stands

  // the support
  bool on_ground_ = false;
  double lifted_ = 0;                      // [s] without weight
  double share_ = 0.5, last_share_ = 0.5;  // [0..1] of the weight on the swing foot

  // balance
  Tipping shift_, worst_shift_;  // of the swing foot; the largest forward shift of the step
  double calm_ = 1;              // [0..1] share of the command
  double lean_ = 0;              // [m] shift of the hip against the mean error
  double error_sum_ = 0;         // [m] of this step
  int errors_ = 0;
  double heading_error_ = 0;  // [rad] behind the commanded turn
  double return_ = 0;         // [rad/s] turn that removes it

  // speed
  Point support_start_;  // [m, torso] the support foot at the beginning of the step
  Command real_speed_;   // as the legs report
  Command correction_;   // added to the planned speed, so that the legs report the commanded one
  double hip_yaw_pitch_ = 0;
  Legs targets_{};
};

}  // namespace robot::nao::walk
