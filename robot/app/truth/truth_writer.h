// The one fused truth of all sensors, as the object /truth/world.
#pragma once

#include <cstdint>
#include <vector>

#include "proto/foresight/truth.pb.h"
#include "robot/core/clock.h"
#include "robot/core/lock.h"
#include "robot/core/report.h"
#include "robot/core/result.h"
#include "robot/memory/memory_object.h"
#include "robot/truth/tracks/tracker.h"

namespace robot::app {

/// Converts a fused truth, whose time of sending is `sent_ns`. Clears and fills `message`.
void to_proto(const truth::FusedTruth& truth, std::uint64_t sent_ns, foresight::GroundTruth& message);

/// The tracks of all sensors. Each sensor's thread brings its detections. The truth is written as soon as each sensor that
/// watches has brought an image since the last writing, or one of them has brought two. Any thread.
class TruthWriter {
 public:
  /// `clock` and `world` outlive this.
  TruthWriter(std::size_t sensors, const Clock& clock, memory::MemoryObject<foresight::GroundTruth>& world);

  /// Sets the place of a calibrated sensor. All tracks begin anew.
  void place(std::size_t sensor, const truth::Sensor& calibrated);

  /// Takes the detections in one image of a calibrated sensor.
  void add(std::size_t sensor, const truth::Detections& detections);

  /// The sensor delivers no images now, so nobody waits for it.
  void lost(std::size_t sensor);

  /// Takes the place where a robot believes to be.
  void identify(const truth::OwnPose& pose);

 private:
  enum class Turn { absent, awaited, brought };
  struct Eye {
    truth::Sensor sensor;
    bool calibrated = false;
    Turn turn = Turn::absent;
  };

  void begin_tracks();
  void write();

  const Clock& clock_;
  memory::MemoryObject<foresight::GroundTruth>& world_;

  Mutex lock_;  // guards all below
  std::vector<Eye> eyes_;
  truth::Tracker tracker_;
  Throttle complaints_;
};

}  // namespace robot::app
