// Coloured points in the layout of foxglove.PointCloud.
#pragma once

#include <cstdint>
#include <string>

#include "robot/net/scene/scene.h"

namespace robot::net {

/// Points on the field [m], 16 bytes each.
class CloudPoints {
 public:
  void reserve(std::size_t points) { data_.reserve(points * kStride); }
  void add(const Point3& place, const Colour& colour);
  std::size_t size() const { return data_.size() / kStride; }

  /// Returns a serialised foxglove.PointCloud in the frame `field`.
  std::string message(std::uint64_t capture_ns) const;

 private:
  static constexpr std::uint32_t kStride = 16;
  std::string data_;
};

}  // namespace robot::net
