// The Nao as a MuJoCo model, written from a table of its links.
#pragma once

#include <string>

namespace robot::nao::walk {

/// The things beside the robot.
struct Scene {
  bool turf = false;  // an uneven ground; its heights are drawn for each trial
  bool ball = false;  // 44 g, 10 cm
  /// Two readings of the published inertias: about the centre of mass of each link, or about its origin. Sources
  /// disagree (facts about the Nao's model), so each robot has one of both.
  bool about_origin = false;
  bool ode = false;   // in the second engine (engine.h)
  bool arms = false;  // the arms move, and all limbs touch the ground, as a robot that lies there needs it
};

/// Returns the model in MuJoCo's XML. Bodies: torso, ball, box. Joints: the names of LoLA in the URDF's spelling.
///
/// Source of masses, inertias and lengths: `naoV50_generated_urdf/nao.urdf` of ros-naoqi/nao_robot (BSD licence).
std::string model_of(const Scene& scene);

inline constexpr double kTurfHeight = 0.01;  // [m] of the highest point that a drawn height of 1 gives
inline constexpr double kBallRadius = 0.05;  // [m]

}  // namespace robot::nao::walk
