// Closed-form kinematics of both legs.
//
// Frame `torso`: origin between the hips, +x forward, +y left, +z up along the torso. Lengths:
// robot/nao/model/dimensions.h. The conventions of the joints are those of LoLA.
#pragma once

#include <array>

namespace robot::nao::walk {

/// The legs, as indices.
enum Side { left, right };
inline constexpr Side other(Side side) { return side == left ? right : left; }
/// Returns +1 for the left side and -1 for the right one: the sign of y on that side.
inline constexpr double sign_of(Side side) { return side == left ? 1 : -1; }

/// The joints of a leg, from the hip to the foot.
enum LegJoint { hip_yaw_pitch, hip_roll, hip_pitch, knee_pitch, ankle_pitch, ankle_roll };
inline constexpr int kLegJoints = 6;

/// The angles of one leg, by LegJoint, and of both legs, by Side [rad]. One motor turns both hip_yaw_pitch joints, so
/// both legs have the same value.
using Leg = std::array<double, kLegJoints>;
using Legs = std::array<Leg, 2>;

/// A point [m, torso].
struct Point {
  double x = 0, y = 0, z = 0;
};

/// A sole: the point under the ankle on the underside of the foot.
struct Sole {
  Point position;  // [m] from the place under the hip, at the height of the hip: z < 0
  double yaw = 0;  // [rad] > 0 to the left
};

/// Returns the legs that put the soles there. The torso leans forward by `tilt` [rad] against the soles. The shared
/// joint can only serve the difference of both yaws, so each foot gets half of it. `guess` is the angle of the shared
/// joint in the last call. A place out of reach gives the nearest length of the leg.
Legs reach(const std::array<Sole, 2>& soles, double tilt, double guess);

/// Returns the place of the sole under the ankle [m, torso], relative to the hip of that leg.
Point sole_of(const Leg& leg, Side side);

}  // namespace robot::nao::walk
