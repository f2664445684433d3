// The interface of everything that delivers depth images: a recording, a live sensor, a synthetic one.
#pragma once

#include <memory>
#include <optional>
#include <string>

#include "robot/core/result.h"
#include "robot/truth/frame/depth_frame.h"

namespace robot::truth {

/// A source of depth images. Used by one thread.
class DepthSource {
 public:
  DepthSource() = default;
  DepthSource(const DepthSource&) = delete;
  DepthSource& operator=(const DepthSource&) = delete;
  virtual ~DepthSource() = default;

  /// Waits for the next image, at most a second. Returns nothing at the end of a recording. Returns an Error, once for each
  /// damaged image or each second without a sensor; the next call goes on behind the damage, or opens the sensor again.
  /// A recording does not pace itself: its images come as fast as they are asked for, with their recorded times.
  virtual Result<std::optional<DepthFrame>> next() = 0;

  /// Returns the address by which it was opened: "freenect:0", "fakenect:logs/kinect".
  virtual const std::string& address() const = 0;

  /// Reports whether a person could walk through the picture now: the images are of this moment, not recorded.
  virtual bool live() const = 0;
};

}  // namespace robot::truth
