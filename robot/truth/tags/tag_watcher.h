// Pictures to ground truth: robots by their printed tags, the ball by its colour.
#pragma once

#include <optional>
#include <string>

#include "robot/core/result.h"
#include "robot/truth/frame/depth_frame.h"
#include "robot/truth/frame/detections.h"
#include "robot/truth/tags/ball_colour.h"
#include "robot/truth/tags/camera.h"
#include "robot/truth/tags/tag_detector.h"
#include "robot/truth/tags/tag_plan.h"
#include "robot/truth/tags/tagged_robots.h"

namespace robot::truth::tags {

struct WatchOptions {
  std::optional<BallLook> ball = BallLook{};  // nothing: the ball has no colour of its own, and is not searched
  int threads = 1;                            // that search for tags
};

/// The observer of one calibrated camera. Used by one thread. A picture of 1280x720 px takes about 45 ms of processor
/// time.
class TagWatcher {
 public:
  /// Returns an Error without libapriltag in the build, or if the plan's family is unknown.
  static Result<TagWatcher> create(Camera camera, TagPlan plan, const WatchOptions& options = {});

  /// Returns the things in a picture; `detected_ns` is left to the caller's clock. Returns an Error if the picture has
  /// another size than the calibration.
  Result<Detections> look(const DepthFrame& picture);

  /// Returns the counts of tags that gave no robot, since the start.
  const RefusedTags& refused() const { return refused_; }

 private:
  TagWatcher(Camera camera, TagPlan plan, std::optional<BallLook> ball, TagDetector detector);

  Camera camera_;
  TagPlan plan_;
  std::optional<BallLook> ball_;
  TagDetector detector_;
  RefusedTags refused_;
};

/// Returns the line about printed tags for --help: their families, or that this build does not see them.
std::string describe_tags();

}  // namespace robot::truth::tags
