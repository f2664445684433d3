// How a robot perceives: camera, detection, localisation and radio, as data.
#pragma once

namespace sim::perception {

/// Both cameras as one: their images overlap (Nao V6: tilts 1.2° and 39.7°, 43.7° high each).
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

/// How likely something is detected: `near` up to `near_range`, falling linearly to `far` at `far_range`, 0 beyond.
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

/// Noise in the image becomes noise on the ground: an error of the tilt moves far things much, near things little.
struct Noise {
  float pixels;        // standard deviation of the place in the image, each axis
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
  float acceleration_noise;  // [m/s²] standard deviation of what may happen to a ball between two images
  float first_velocity;      // [m/s] standard deviation when it is first seen
  float reacquire;           // [standard deviations] a percept farther off starts the filter anew
  float lost_deviation;      // [m] the uncertainty stops to grow here
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

/// Odometry drifts, marks correct it. That images nearer together than `mark_interval` share their errors is why the
/// marks are not looked at more often.
struct Localisation {
  float start_deviation;          // [m] on entering the field
  float start_deviation_heading;  // [rad]
  float bias;                     // standard deviation of the odometry's scale, of this robot in this game
  float translation_noise;        // standard deviation along each axis after a metre; grows with the way's root
  float rotation_noise;           // standard deviation after a radian; grows with the angle's root
  float rotation_per_metre;       // [rad/m^0.5] heading lost by walking straight
  float mark_interval;            // [s] between two looks at the marks
  float mark_near;                // [0..1] probability of detecting a mark that is in view, next to it
  float mark_range;               // [m] where that has fallen to 0
  float mark_deviation;           // [m] error of one mark 1 m away: half of it at the feet, growing with the square
  float mark_deviation_heading;   // [rad] of one mark
  float flips_per_minute;         // [1/min] turned round by mistake, while unsure of the pose
  float flip_duration;            // [s] until it is noticed, on average

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
  }
};

/// The team's radio. How often a robot may send is in the rules.
struct Radio {
  float delay;  // [s] mean of an exponential delay
  float loss;   // [0..1] of packets, for each receiver on its own

  template <class Self, class See>
  static void visit(Self& self, See&& see) {
    see("delay", self.delay, "s", 0.f, 5.f);
    see("loss", self.loss, "", 0.f, 1.f);
  }
};

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
