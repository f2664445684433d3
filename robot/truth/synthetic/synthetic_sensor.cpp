#include "robot/truth/synthetic/synthetic_sensor.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace robot::truth {

SyntheticSensor::SyntheticSensor(const SensorPose& pose, const Surroundings& surroundings,
                                 std::function<Scene(std::uint64_t)> scene_at, SyntheticOptions options)
    : renderer_(pose, surroundings, options.render), scene_at_(std::move(scene_at)), options_(std::move(options)) {}

Result<std::optional<DepthFrame>> SyntheticSensor::next() {
  if (options_.now_ns) {
    const double since_ns = static_cast<double>(options_.now_ns()) - static_cast<double>(options_.first_capture_ns);
    number_ =
        std::max(number_, static_cast<std::uint64_t>(std::ceil(std::max(0.0, since_ns) * options_.rate_hz / 1e9)));
  }
  const double since_first_ns = std::round(static_cast<double>(number_) * 1e9 / options_.rate_hz);
  const std::uint64_t capture_ns = options_.first_capture_ns + static_cast<std::uint64_t>(since_first_ns);
  DepthFrame frame = renderer_.render(scene_at_(capture_ns), number_++);
  frame.capture_ns = capture_ns;
  return std::optional(std::move(frame));
}

}  // namespace robot::truth
