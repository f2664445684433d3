#include "robot/app/truth/finder.h"

#include <memory>
#include <utility>

#include "robot/truth/detection/detector.h"
#include "robot/truth/tags/tag_watcher.h"

namespace robot::app {
namespace {

using MadeFinder = Result<std::unique_ptr<PlacedFinder>>;

class DepthFinder final : public PlacedFinder {
 public:
  explicit DepthFinder(truth::Detector detector) : detector_(std::move(detector)) {}

  Result<truth::Detections> find(const truth::DepthFrame& frame) override { return detector_.detect(frame); }
  Result<void> learn_background(const truth::DepthFrame& frame) override { return detector_.learn_background(frame); }
  std::size_t background_images() const override { return detector_.background_images(); }

 private:
  truth::Detector detector_;
};

class TagFinder final : public PlacedFinder {
 public:
  explicit TagFinder(truth::tags::TagWatcher watcher) : watcher_(std::move(watcher)) {}

  Result<truth::Detections> find(const truth::DepthFrame& frame) override { return watcher_.look(frame); }
  std::optional<truth::tags::RefusedTags> refused() const override { return watcher_.refused(); }

 private:
  truth::tags::TagWatcher watcher_;
};

}  // namespace

Result<void> PlacedFinder::learn_background(const truth::DepthFrame&) {
  return Error{"an ordinary camera has no depths, so it cannot learn the empty field"};
}

Finder depth_finder(const sim::field::Field& field, const truth::DetectorOptions& options) {
  return {.at = [field, options](const PlacedSensor& placed) -> MadeFinder {
            auto made = truth::Detector::create(placed.pose, field, options);
            if (!made) return made.failure();
            return std::unique_ptr<PlacedFinder>(std::make_unique<DepthFinder>(std::move(*made)));
          },
          .robots = truth::Ranging::depth};
}

Finder tag_finder(const truth::tags::TagPlan& plan, const std::optional<truth::tags::BallLook>& ball) {
  return {.at = [plan, ball](const PlacedSensor& placed) -> MadeFinder {
            const truth::tags::Camera camera{.projection = {placed.pose.intrinsics, placed.lens},
                                             .field_from_camera = placed.pose.field_from_sensor};
            auto made = truth::tags::TagWatcher::create(camera, plan, {.ball = ball, .threads = 2});
            if (!made) return made.failure();
            return std::unique_ptr<PlacedFinder>(std::make_unique<TagFinder>(std::move(*made)));
          },
          .robots = truth::Ranging::plane};
}

}  // namespace robot::app
