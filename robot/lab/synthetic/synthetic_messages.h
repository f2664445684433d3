// The messages of the synthetic robot: its sensors, beliefs and actions.
#pragma once

#include <cstdint>
#include <optional>

#include "proto/foresight/agent.pb.h"
#include "proto/foresight/ball.pb.h"
#include "proto/foresight/camera.pb.h"
#include "proto/foresight/game.pb.h"
#include "proto/foresight/motion.pb.h"
#include "proto/foresight/pose.pb.h"
#include "proto/foresight/sensors.pb.h"
#include "proto/foresight/team.pb.h"
#include "proto/foresight/truth.pb.h"
#include "proto/foresight/vision.pb.h"
#include "robot/lab/synthetic/synthetic_camera.h"
#include "robot/lab/synthetic/synthetic_world.h"

namespace robot::lab::synthetic {

namespace pb = foresight;

/// Noise with an address: the same (seed, stream, step) gives the same value, independent of other calls.
class Noise {
 public:
  enum Stream : std::uint64_t { kInertial, kJoints, kBallX, kBallY, kPixel, kPoseX, kPoseY, kPoseHeading, kParticles };

  explicit Noise(std::uint64_t seed) : seed_(seed) {}

  /// Returns a nearly normal number, mean 0, standard deviation 1.
  double operator()(Stream stream, std::uint64_t step) const;

 private:
  std::uint64_t seed_;
};

/// The memory of the ball filter at one decision.
struct Sight {
  bool visible = false;
  std::optional<double> last_seen;  // [s] the newest image that showed the ball
  unsigned run = 0;                 // [images] in a row, up to this one, with the same result: ball or no ball
};

/// The time of a message, with the step and the size of images.
struct SyntheticMoment {
  double t = 0;            // [s] since the start
  std::uint64_t step = 0;  // of the body, 100 Hz
  std::uint64_t epoch_ns = 0;
  int width = 0, height = 0;  // [px] of images
};

/// Returns the angles of head and torso.
Bearing bearing_at(double t);

pb::Joints joints_of(const SyntheticMoment& moment, const Noise& noise);
pb::Inertial inertial_of(const SyntheticMoment& moment, const Noise& noise);
pb::Fsr fsr_of(const SyntheticMoment& moment);
pb::Touch touch_of(const SyntheticMoment& moment);
pb::Battery battery_of(const SyntheticMoment& moment);
pb::Odometry odometry_of(const SyntheticMoment& moment);
pb::MotionStatus motion_status_of(const SyntheticMoment& moment);

pb::CameraMatrix camera_matrix_of(const SyntheticMoment& moment);
pb::Image image_of(const SyntheticMoment& moment);
pb::Vision vision_of(const SyntheticMoment& moment, const Sight& sight, const Noise& noise);

/// Returns the believed ball, or nothing before the first sight.
std::optional<pb::Ball> ball_of(const SyntheticMoment& moment, const Sight& sight, const Noise& noise);
pb::Pose pose_of(const SyntheticMoment& moment, const Noise& noise);
pb::Team team_of(const SyntheticMoment& moment);
pb::GameState game_of(const SyntheticMoment& moment);
pb::DecisionTrace decision_of(const SyntheticMoment& moment, const std::optional<pb::Ball>& ball);
pb::MotionCommand motion_command_of(const SyntheticMoment& moment);
pb::GroundTruth truth_of(const SyntheticMoment& moment);

/// Returns whether the ball is detectable in the image of time `t`.
bool ball_visible(double t, int width, int height);

}  // namespace robot::lab::synthetic
