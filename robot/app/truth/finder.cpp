#include "robot/app/truth/finder.h"

#include <memory>
#include <utility>

#include "robot/truth/detection/detector.h"
#include "robot/truth/tags/tag_watcher.h"

namespace robot::app {

Finder depth_finder(const sim::field::Field& field, const truth::DetectorOptions& options) {
  return {.at = [field, options](const PlacedSensor& placed) -> Result<Find> {
            auto made = truth::Detector::create(placed.pose, field, options);
            if (!made) return made.failure();
            const auto detector = std::make_shared<truth::Detector>(std::move(*made));
            return Find([detector](const truth::DepthFrame& frame) { return detector->detect(frame); });
          },
          .robots = truth::Ranging::depth};
}

Finder tag_finder(const truth::tags::TagPlan& plan, const std::optional<truth::tags::BallLook>& ball) {
  return {.at = [plan, ball](const PlacedSensor& placed) -> Result<Find> {
            const truth::tags::Camera camera{.projection = {placed.pose.intrinsics, placed.lens},
                                             .field_from_camera = placed.pose.field_from_sensor};
            auto made = truth::tags::TagWatcher::create(camera, plan, {.ball = ball, .threads = 2});
            if (!made) return made.failure();
            const auto watcher = std::make_shared<truth::tags::TagWatcher>(std::move(*made));
            return Find([watcher](const truth::DepthFrame& frame) {
              return watcher->look({.size = {.width = frame.intrinsics.width, .height = frame.intrinsics.height},
                                    .rgb = frame.rgb,
                                    .capture_ns = frame.capture_ns});
            });
          },
          .robots = truth::Ranging::plane};
}

}  // namespace robot::app
