// One sensor: its thread reads images, finds robots and ball, and shows both.
#pragma once

#include <atomic>
#include <cstdint>
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <thread>

#include "proto/foresight/truth.pb.h"
#include "proto/foxglove/RawImage.pb.h"
#include "robot/app/truth/calibrations.h"
#include "robot/app/truth/finder.h"
#include "robot/app/truth/pulse.h"
#include "robot/app/truth/truth_writer.h"
#include "robot/core/clock.h"
#include "robot/core/lock.h"
#include "robot/core/result.h"
#include "robot/memory/channels.h"
#include "robot/memory/memory_object.h"
#include "robot/truth/frame/depth_source.h"

namespace robot::app {

/// The objects of one sensor: "/truth/1/sensor", "/truth/1/depth", "/truth/1/color".
struct SensorObjects {
  SensorObjects(std::size_t index, const Clock& clock);

  memory::MemoryObject<foresight::TruthSensor> sensor;
  memory::MemoryObject<::foxglove::RawImage> depth, color;
};

struct SensorWatchOptions {
  std::size_t index = 0;  // of the sensor; its number on the wire is one more
  Finder finder;
  bool paced = false;  // the images come as fast as they are asked for, and are shown at their capture times
};

/// The thread of one sensor. An ordinary camera is one whose images have no depths.
class SensorWatch {
 public:
  /// `clock`, `writer` and `calibrations` outlive this.
  SensorWatch(SensorWatchOptions options, std::unique_ptr<truth::DepthSource> source, const Clock& clock,
              const Calibrations& calibrations, TruthWriter& writer);
  ~SensorWatch();

  /// Adds the sensor's objects to `channels`, which then keeps them alive.
  Result<void> list(memory::Channels& channels) const;

  /// Starts the thread, once.
  Result<void> start();
  void stop();

  const std::string& address() const { return source_->address(); }

  /// Returns the newest image, or null before the first one. Any thread.
  std::shared_ptr<const truth::DepthFrame> newest() const;

  /// Makes the thread use a new place of the sensor, from the next image on. Any thread.
  void place(const PlacedSensor& placed);

  /// Makes the thread take the next images as the empty field, and returns their number. Nothing is detected meanwhile.
  /// A new place begins without a background. Returns an Error if the sensor sends no images now, for an ordinary camera, and
  /// for a sensor that is not calibrated. Any thread.
  Result<std::size_t> learn_background();

 private:
  void run();
  bool read_one();
  void lose(const std::string& problem);
  void look(const std::shared_ptr<const truth::DepthFrame>& frame);
  void leave_out();
  bool wait_until(std::uint64_t capture_ns);  // false: the thread ends meanwhile
  void take_place(const truth::DepthFrame& frame);
  void use(const PlacedSensor& placed);
  void begin_background();
  bool search(const truth::DepthFrame& frame);  // false: seen_ is empty
  void learn(const truth::DepthFrame& frame);
  void show(const truth::DepthFrame& frame);
  void tell(foresight::TruthSensor::State state, std::uint64_t capture_ns);

  const SensorWatchOptions options_;
  const std::string name_;  // "sensor 1"
  const std::unique_ptr<truth::DepthSource> source_;
  const Clock& clock_;
  const Calibrations& calibrations_;
  TruthWriter& writer_;
  const std::shared_ptr<SensorObjects> objects_;

  // used by the sensor's thread only
  std::unique_ptr<PlacedFinder> finder_;  // null: not calibrated
  std::optional<PlacedSensor> placed_;
  std::optional<truth::Intrinsics> pinhole_;  // of the newest image
  truth::Detections seen_;                    // in it
  std::string problem_;
  std::string refusal_;                 // the reason why finder_ is null; empty: nobody has calibrated the sensor
  bool asked_ = false;                  // for a saved calibration
  std::size_t background_awaited_ = 0;  // images of the empty field to come
  Pulse pulse_;
  std::uint64_t left_out_ = 0;               // images that came too late
  std::uint64_t shown_ns_ = monotonic_ns();  // [ns, monotonic] of the newest image that was not left out

  mutable Mutex lock_;  // guards the next five, and is held when stopping_ changes
  std::shared_ptr<const truth::DepthFrame> newest_;
  std::optional<PlacedSensor> wanted_;
  bool background_wanted_ = false;
  bool watching_ = false, calibrated_ = false;  // as last told
  std::atomic<bool> stopping_ = false;
  Condition changed_;
  std::thread thread_;  // last, because it uses all the others
};

}  // namespace robot::app
