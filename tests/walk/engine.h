// A physics engine with one robot on the ground.
#pragma once

#include <array>
#include <cstddef>
#include <memory>

#include "robot/nao/walk/sensors.h"
#include "tests/walk/dice.h"
#include "tests/walk/drawn_robot.h"
#include "tests/walk/nao_model.h"

namespace robot::nao::walk {

/// The motors: those of the left leg, of the right leg, and of both arms if they move, each from the torso outwards.
inline constexpr std::size_t kLegMotors = 2 * kLegJoints;
inline constexpr std::size_t kArmJoints = 4;
inline constexpr std::size_t kMotors = kLegMotors + 2 * kArmJoints;
using PerMotor = std::array<double, kMotors>;

/// Gain, damping and armature of an arm's servo, of those of a leg: as their torques.
inline constexpr double kArmShare = 0.22;
inline constexpr double kGravity = 9.81;  // [m/s²]
/// The damping of a joint without its servo [N m s/rad].
inline constexpr double kJointDamping = 0.1;

/// The joint of a motor.
struct JointState {
  double angle = 0;  // [rad]
  double speed = 0;  // [rad/s]
};

/// The ball on the ground.
struct RollingBall {
  double x = 0, y = 0;    // [m, world]
  double vx = 0, vy = 0;  // [m/s, world]
};

/// Moves the links of one robot by the torques of its motors. The world has gravity and a ground with friction. SI units.
/// Used by one thread.
class Engine {
 public:
  static constexpr double kStep = 0.002;  // [s]

  virtual ~Engine() = default;

  /// Puts a robot on the ground with these angles of its joints and its torso at this height. The dice draw the ground.
  virtual void reset(const DrawnRobot& robot, Dice& dice, const PerMotor& angles, double torso_height) = 0;
  /// Turns the torso by a quaternion (w, x, y, z), at this height.
  virtual void turn(double torso_height, const std::array<double, 4>& rotation) = 0;
  /// Simulates `kStep`.
  virtual void step() = 0;

  virtual double now() const = 0;
  /// Returns the motors, kLegMotors or kMotors.
  virtual std::size_t motors() const = 0;
  virtual JointState joint(std::size_t motor) const = 0;
  /// Drives the joint by this torque [N m] until the next call.
  virtual void drive(std::size_t motor, double torque) = 0;
  /// Pushes the torso by this force [N, world] until the next call.
  virtual void push(double x, double y) = 0;

  /// Returns the place of the torso's origin [m, world].
  virtual std::array<double, 3> position() const = 0;
  /// Returns the axes of the torso in the world, as the columns of a matrix by rows.
  virtual std::array<double, 9> rotation() const = 0;
  /// Returns the turn rate of the torso [rad/s, torso].
  virtual std::array<double, 3> rate() const = 0;
  /// Returns the forces on the foot sensors [N]: left and right foot, each front left, front right, rear left, rear right.
  virtual std::array<double, 8> loads() const = 0;

  virtual bool has_ball() const = 0;
  virtual RollingBall ball() const = 0;
  /// Puts the ball there; it rolls.
  virtual void place(const RollingBall& ball) = 0;
};

std::unique_ptr<Engine> mujoco_engine(const Scene& scene);
/// A second opinion, by the Open Dynamics Engine: flat ground, arms that hang down, no ball. It takes the links from the same
/// model and has solvers of its own for joints and contacts. Without the package libode-dev it is null.
std::unique_ptr<Engine> ode_engine(const Scene& scene);

}  // namespace robot::nao::walk
