// One simulated robot, from the targets of its joints to its sensors.
#pragma once

#include <cstdint>
#include <deque>
#include <memory>

#include "robot/nao/walk/sensors.h"
#include "tests/walk/dice.h"
#include "tests/walk/drawn_robot.h"
#include "tests/walk/engine.h"
#include "tests/walk/nao_model.h"

namespace robot::nao::walk {

/// The true pose of the torso, and the ball.
struct Truth {
  double x = 0, y = 0, height = 0;  // [m, world]
  double heading = 0;               // [rad] (-π, π]
  double upright = 1;               // cosine of the tilt
  double fall_direction = 0;        // [rad] of the tilt, from the robot's front, > 0 to the left
  double face_up = 0;               // 1: it lies on its back, -1: on its front
  double ball_x = 0, ball_y = 0;    // [m, world]
  double ball_speed = 0;            // [m/s]
  double ball_direction = 0;        // [rad] of its velocity, from the robot's front
};

/// The joints of an arm, from the shoulder to the hand.
enum ArmJoint { shoulder_pitch, shoulder_roll, elbow_yaw, elbow_roll };

/// The angles of both arms, by Side and ArmJoint [rad].
using Arms = std::array<std::array<double, kArmJoints>, 2>;

/// A simulated robot with servos, delays and imperfect sensors. It may be reset for any number of robots with the same
/// scene. Used by one thread.
class Physics {
 public:
  static constexpr double kStep = Engine::kStep;  // [s]

  /// The scene selects the engine: MuJoCo, or ODE.
  explicit Physics(const Scene& scene);

  /// Puts the robot on its feet with these angles of the limbs. `hip_height` [m] is that of the hip above the soles.
  /// `seed` settles the noise of its sensors, and the ground.
  void reset(const DrawnRobot& robot, std::uint64_t seed, const Legs& legs, double hip_height, const Arms& arms = {});

  /// Drops the robot from a small height, its torso turned by `roll` and then `pitch` [rad]: (0, π / 2) is face down.
  void drop(const DrawnRobot& robot, std::uint64_t seed, const Legs& legs, const Arms& arms, double roll, double pitch);

  /// Returns a frame of sensors.
  Sensors sense();
  /// Accepts targets, which take effect after the robot's delay. `stiffness` [0..1] is the share of the servos' gain.
  /// Arms of a scene without arms hang down, whatever their targets.
  void command(const Legs& targets, double stiffness = 1, const Arms& arms = {});
  /// Simulates `kStep`, with a force on the torso [N, world].
  void step(double force_x, double force_y);

  Truth truth() const;
  /// Returns the angles of the arms, of a scene with arms.
  Arms arms() const;
  double now() const;

  /// Puts the ball on the ground [m, robot: on the ground under the torso]. It moves off ahead with `speed` [m/s].
  void place_ball(double ahead, double left, double speed = 0);

 private:
  struct Target {
    double time = 0;
    PerMotor angles{};
    double stiffness = 1;
  };

  double torque(std::size_t motor) const;

  std::unique_ptr<Engine> engine_;
  DrawnRobot robot_;
  PerMotor offset_{};  // [rad] of the joints' sensors
  Dice dice_{0};
  std::deque<Target> queue_;
  Target target_;
  double roll_ = 0, pitch_ = 0;  // [rad] as the inertial unit has them
  double sensed_at_ = 0;
};

}  // namespace robot::nao::walk
