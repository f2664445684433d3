// The synthetic sensor as a source of depth images.
#pragma once

#include <functional>
#include <string>

#include "robot/truth/frame/depth_source.h"
#include "robot/truth/synthetic/renderer.h"

namespace robot::truth {

struct SyntheticOptions {
  std::string address = "synthetic";
  double rate_hz = 30;                 // > 0
  std::uint64_t first_capture_ns = 0;  // [ns since the epoch]
  bool live = true;                    // the caller paces the images, so that they are of this moment
  RenderOptions render = {};
  /// [ns since the epoch] the clock of a sensor that skips images; without one it makes all.
  std::function<std::uint64_t()> now_ns = nullptr;
};

/// A sensor that looks at scenes of its caller. It never ends, never fails and does not pace itself: each call of next()
/// asks for the scene at the next capture time and returns its image at once. With a clock it skips the images whose time
/// has passed, so that a slow machine gets fewer images instead of ever later ones.
class SyntheticSensor : public DepthSource {
 public:
  SyntheticSensor(const SensorPose& pose, const Surroundings& surroundings,
                  std::function<Scene(std::uint64_t capture_ns)> scene_at, SyntheticOptions options = {});

  Result<std::optional<DepthFrame>> next() override;
  const std::string& address() const override { return options_.address; }
  bool live() const override { return options_.live; }

 private:
  Renderer renderer_;
  std::function<Scene(std::uint64_t)> scene_at_;
  SyntheticOptions options_;
  std::uint64_t number_ = 0;  // of the next image
};

}  // namespace robot::truth
