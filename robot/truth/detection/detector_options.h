// The properties of a league's robots and ball that a detector must know.
#pragma once

namespace robot::truth {

/// The colours of an orange ball: hues [deg] from red (0) to yellow (60), least saturation and brightness, 0..1.
struct Orange {
  double least_hue_deg = 5, most_hue_deg = 40;
  double least_saturation = 0.55, least_brightness = 0.3;
};

struct DetectorOptions {
  double ball_radius = 0.05;  // [m]

  bool orange_ball = true;  // images with colours: the ball is found by them; false: always by its shape
  Orange orange;
  /// The colour of the thing at pixel p of the depth image is at p + shift. No registration of colours is perfect.
  double colour_shift_x = 0, colour_shift_y = 0;  // [px]
  double colour_deviation = 0.10;                 // [px] one standard deviation of the rest, in each direction

  double robot_height = 0.58;  // [m] of a standing robot
  /// The distance from the middle of the visible surface of a robot's head to the middle between its feet [m], in a level
  /// view; it is shorter in a steep one. The default fits a Nao. fit_surface_to_centre() measures it.
  double surface_to_centre = 0.054;
  /// The distance of a robot's head from the vertical through the middle between its feet: one standard deviation [m] in
  /// each direction. The default fits robots that do not sway.
  double posture_deviation = 0.005;
};

}  // namespace robot::truth
