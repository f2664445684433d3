// The model of perception, as data: camera, detection, localisation, radio.
#pragma once

namespace sim::perception {

/// Both cameras together, because their images overlap (Nao V6: tilts 1.2° and 39.7°, 43.7° high each).
struct Camera {
  float height;       // [m] above ground
  float width;        // [rad] of the view, horizontally
  float upper_edge;   // [rad] below the horizon with pitch 0, < 0: above it
  float lower_edge;   // [rad] likewise
  float pixel_angle;  // [rad] per pixel of the vision's image
  float latency;      // [s] from the image to the belief

  template <class Self, class See>
  static void visit(Self& self, See&& see) {
    see("height", self.height, "m", 0.1f, 2.f);
    see("width", self.width, "rad", 0.1f, 3.1f);
    see("upper_edge", self.upper_edge, "rad", -1.5f, 1.5f);
    see("lower_edge", self.lower_edge, "rad", -1.5f, 1.55f);
    see("pixel_angle", self.pixel_angle, "rad", 0.f, 0.05f);
    see("latency", self.latency, "s", 0.f, 0.1f);
  }
};

/// The probability of a detection: `near` up to `near_range`, falling linearly to `far` at `far_range`, 0 beyond.
struct Detection {
  float near;
  float far;
  float near_range;  // [m]
  float far_range;   // [m]

  template <class Self, class See>
  static void visit(Self& self, See&& see) {
    see("near", self.near, "", 0.f, 1.f);
    see("far", self.far, "", 0.f, 1.f);
    see("near_range", self.near_range, "m", 0.f, 30.f);
    see("far_range", self.far_range, "m", 0.01f, 30.f);
  }
};

/// The noise in the image. On the ground an error of the tilt displaces far things much and near things little.
struct Noise {
  float pixels;        // [px] standard deviation of the place in the image, each axis
  float tilt;          // [rad] standard deviation of the camera's tilt, standing
  float tilt_walking;  // [rad] walking
  float roll;          // [rad] of the bearing beyond the pixels

  template <class Self, class See>
  static void visit(Self& self, See&& see) {
    see("pixels", self.pixels, "px", 0.f, 20.f);
    see("tilt", self.tilt, "rad", 0.f, 0.2f);
    see("tilt_walking", self.tilt_walking, "rad", 0.f, 0.2f);
    see("roll", self.roll, "rad", 0.f, 0.2f);
  }
};

/// The ball filter: constant velocity with the turf's deceleration, one variance for both axes.
struct BallFilter {
  float acceleration_noise;  // [m/s²] standard deviation of the ball's acceleration between two images
  float first_velocity;      // [m/s] standard deviation of the velocity at the first percept
  float reacquire;           // [standard deviations] a percept farther off restarts the filter
  float lost_deviation;      // [m] greatest deviation; a ball that uncertain may be anywhere
  float false_per_second;    // [1/s] false percepts

  template <class Self, class See>
  static void visit(Self& self, See&& see) {
    see("acceleration_noise", self.acceleration_noise, "m/s²", 0.f, 20.f);
    see("first_velocity", self.first_velocity, "m/s", 0.f, 10.f);
    see("reacquire", self.reacquire, "", 1.f, 100.f);
    see("lost_deviation", self.lost_deviation, "m", 0.1f, 30.f);
    see("false_per_second", self.false_per_second, "1/s", 0.f, 3.f);
  }
};

/// The localisation: odometry drifts, marks correct it. Images within one `mark_interval` share their errors, so the
/// marks are used once in that time.
struct Localisation {
  float start_deviation;          // [m] on entering the field
  float start_deviation_heading;  // [rad]
  float bias;                     // standard deviation of the odometry's scale, drawn per robot and game
  float translation_noise;        // [m^0.5] standard deviation along each axis after 1 m; grows with the way's root
  float rotation_noise;           // [rad^0.5] standard deviation after 1 rad; grows with the angle's root
  float rotation_per_metre;       // [rad/m^0.5] standard deviation of the heading after 1 m
  float mark_interval;            // [s] between two looks at the marks
  float mark_near;                // [0..1] probability of detecting a mark in view right in front of the robot
  float mark_range;               // [m] distance at which that probability is 0
  float mark_deviation;           // [m] error of one mark 1 m away: half of it at the feet, growing with the square
  float mark_deviation_heading;   // [rad] error of one mark
  float flips_per_minute;         // [1/min] flips of an unsure pose
  float flip_duration;            // [s] mean time until the robot notices a flip
  float fall_deviation;           // [m] standard deviation of the shift by a fall, each axis
  float fall_deviation_heading;   // [rad] standard deviation of the turn by a fall

  template <class Self, class See>
  static void visit(Self& self, See&& see) {
    see("start_deviation", self.start_deviation, "m", 0.f, 3.f);
    see("start_deviation_heading", self.start_deviation_heading, "rad", 0.f, 3.f);
    see("bias", self.bias, "", 0.f, 0.5f);
    see("translation_noise", self.translation_noise, "m^0.5", 0.f, 1.f);
    see("rotation_noise", self.rotation_noise, "rad^0.5", 0.f, 1.f);
    see("rotation_per_metre", self.rotation_per_metre, "rad/m^0.5", 0.f, 1.f);
    see("mark_interval", self.mark_interval, "s", 0.03f, 5.f);
    see("mark_near", self.mark_near, "", 0.f, 1.f);
    see("mark_range", self.mark_range, "m", 0.1f, 20.f);
    see("mark_deviation", self.mark_deviation, "m", 0.001f, 1.f);
    see("mark_deviation_heading", self.mark_deviation_heading, "rad", 0.001f, 1.f);
    see("flips_per_minute", self.flips_per_minute, "1/min", 0.f, 10.f);
    see("flip_duration", self.flip_duration, "s", 0.1f, 300.f);
    see("fall_deviation", self.fall_deviation, "m", 0.f, 3.f);
    see("fall_deviation_heading", self.fall_deviation_heading, "rad", 0.f, 3.f);
  }
};

/// The team's radio. The rules limit how often a robot may send.
struct Radio {
  float delay;  // [s] mean of an exponential distribution
  float loss;   // [0..1] probability per packet and receiver

  template <class Self, class See>
  static void visit(Self& self, See&& see) {
    see("delay", self.delay, "s", 0.f, 5.f);
    see("loss", self.loss, "", 0.f, 1.f);
  }
};

/// All of a robot's perception.
struct Model {
  Camera camera;
  Detection ball;
  Detection robots;
  Noise noise;
  BallFilter filter;
  Localisation localisation;
  Radio radio;
};

}  // namespace sim::perception
