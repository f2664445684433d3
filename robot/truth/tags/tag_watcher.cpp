#include "robot/truth/tags/tag_watcher.h"

#include <utility>

#include "robot/core/text.h"
#include "robot/truth/tags/tag_family.h"

namespace robot::truth::tags {

Result<TagWatcher> TagWatcher::create(Camera camera, TagPlan plan, const WatchOptions& options) {
  Result<TagDetector> detector = TagDetector::create({.family = plan.family, .threads = options.threads});
  if (!detector) return detector.failure();
  return TagWatcher(std::move(camera), std::move(plan), options.ball, *std::move(detector));
}

TagWatcher::TagWatcher(Camera camera, TagPlan plan, std::optional<BallLook> ball, TagDetector detector)
    : camera_(std::move(camera)), plan_(std::move(plan)), ball_(ball), detector_(std::move(detector)) {}

Result<Detections> TagWatcher::look(const DepthFrame& picture) {
  const Intrinsics& expected = camera_.projection.intrinsics;
  if (picture.intrinsics.width != expected.width || picture.intrinsics.height != expected.height)
    return Error{formatted("picture: expected the calibration's size %dx%d, got %dx%d", expected.width, expected.height,
                           picture.intrinsics.width, picture.intrinsics.height)};
  Detections detections;
  detections.capture_ns = picture.capture_ns;
  detections.robots = tagged_robots(camera_, plan_, detector_.detect(picture), refused_);
  if (ball_) detections.ball = find_ball(picture, camera_, *ball_);
  return detections;
}

std::string describe_tags() {
  return sees_tags() ? "  printed tags of the family " + family_names() + "\n"
                     : "  printed tags are not in this build: libapriltag-dev was not installed\n";
}

}  // namespace robot::truth::tags
