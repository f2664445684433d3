// A synthetic depth camera: looks at a scene from a pose.
#pragma once

#include <cstdint>

#include "robot/truth/frame/sensor_pose.h"
#include "robot/truth/synthetic/cast.h"
#include "robot/truth/synthetic/disparity_noise.h"
#include "robot/truth/synthetic/scene.h"
#include "robot/truth/synthetic/surroundings.h"

namespace robot::truth {

struct RenderOptions {
  bool colour = true;  // the frames have colours
  bool noise = true;   // false: each depth is exact to half a unit of the image, and no pixel is lost
};

/// A synthetic sensor at a fixed place. The empty field is drawn once, and each frame draws only the things that move.
/// Used by one thread.
class Renderer {
 public:
  Renderer(const SensorPose& pose, const Surroundings& surroundings, RenderOptions options = {});

  /// Returns the image of a scene. The same scene and number give the same image; another number gives other noise.
  /// The capture time is 0.
  DepthFrame render(const Scene& scene, std::uint64_t number);

  /// Returns the exact image of the last scene.
  const Cast& cast() const { return cast_; }
  const SensorPose& pose() const { return pose_; }

 private:
  void draw_bodies(const Scene& scene);

  SensorPose pose_;
  RenderOptions options_;
  Cast empty_, cast_;
  DisparityNoise noise_;
  std::vector<Capsule> bodies_;  // of the last scene [m, field]
};

}  // namespace robot::truth
