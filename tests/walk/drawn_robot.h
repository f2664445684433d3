// Robots that differ: no two Naos walk alike.
#pragma once

#include <array>
#include <cstdint>

namespace robot::nao::walk {

/// The strength of the servos. Stiff: as new. Soft: as HULKs measured, worn or warm.
enum class Servos { stiff, soft };

/// Everything about one robot and its ground that a trial draws. SI units, angles in radians.
struct DrawnRobot {
  Servos servos = Servos::stiff;
  double gain = 60;                               // [N m/rad] of the servos
  double damping = 1;                             // [N m s/rad] of the joints
  double armature = 0.01;                         // [kg m²]
  double torque = 1;                              // share of the motors' torque
  double warms = 0;                               // [s] until its servos are as weak as soft ones; 0: they stay cold
  double play = 0;                                // [rad] of the joints
  double friction = 0.8;                          // of soles and ground
  double softness = 0.01;                         // [s] time constant of contacts
  double turf = 0;                                // [m] height of the ground's bumps
  double delay = 0.02;                            // [s] from a target to its effect
  bool about_origin = false;                      // Scene::about_origin
  std::array<std::array<double, 6>, 2> offset{};  // [rad] of the joints, by Side
  std::array<double, 3> rate_bias{};              // [rad/s]
  double rate_noise = 0.03;                       // [rad/s]
  double angle_lag = 0;                           // [s] of the torso's angles
  double roll_bias = 0, pitch_bias = 0;           // [rad]
  std::array<double, 8> load_gain{};              // of the foot sensors; 0: dead
};

inline constexpr double kSoftTorque = 0.56;  // share of the motors' torque of soft servos, as HULKs measured
inline constexpr double kSoftGain = 21.5;    // [N m/rad] in the middle of theirs

/// Returns the robot of this seed. `wider` is the factor of all ranges: 1, or 1.2 for the check beyond them.
DrawnRobot draw_robot(std::uint64_t seed, Servos servos, double wider = 1);

}  // namespace robot::nao::walk
