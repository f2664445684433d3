// The lengths of a Nao.
#pragma once

namespace robot::nao {

enum class Camera { top, bottom };

/// Mounting of a camera in the head: in front of and above the neck [m], and its angle downwards [rad].
struct CameraMount {
  double x, z, tilt;
};

/// The lengths of a Nao [m]. V4, V5 and V6 have the same ones (B-Human, HULKs, Aldebaran's documentation).
struct Dimensions {
  double thigh = 0.1, tibia = 0.1029, foot_height = 0.04519;
  double hip_half_width = 0.05;  // from the hip frame to a leg
  double hip_to_neck = 0.2115;
  CameraMount top{.x = 0.05871, .z = 0.06364, .tilt = 0.020944};     // 1.2°
  CameraMount bottom{.x = 0.05071, .z = 0.01774, .tilt = 0.692896};  // 39.7°

  const CameraMount& camera(Camera which) const { return which == Camera::top ? top : bottom; }
};

}  // namespace robot::nao
