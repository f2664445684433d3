// The few calls to the driver of a live depth sensor, or to a stand-in for one.
#pragma once

#include <optional>

#include "robot/core/result.h"
#include "robot/truth/frame/depth_frame.h"

namespace robot::truth {

/// A driver of one sensor. Used by one thread.
class SensorDriver {
 public:
  SensorDriver() = default;
  SensorDriver(const SensorDriver&) = delete;
  SensorDriver& operator=(const SensorDriver&) = delete;
  virtual ~SensorDriver() = default;

  /// Opens and starts the sensor, which is closed. Returns an Error with the refused step; the sensor is then closed.
  virtual Result<void> open() = 0;

  /// Stops and closes the sensor. No effect on a closed one.
  virtual void close() = 0;

  /// Waits for an image of the open sensor, at most `patience_ms`. Returns nothing if none came or the one that came was
  /// damaged, and an Error if the sensor is gone. Images that are older than the newest one are passed over.
  virtual Result<std::optional<DepthFrame>> newest(int patience_ms) = 0;
};

}  // namespace robot::truth
