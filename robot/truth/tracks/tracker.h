// Ground truth while it happens: detections of several sensors become one fused truth.
#pragma once

#include <memory>

#include "robot/core/result.h"
#include "robot/truth/tracks/fusion.h"

namespace robot::truth {

/// The tracks of all robots and of the ball. Pure: no clock. Used by one thread. Memory and time per image are bounded.
///
///   if (const auto used = tracker.add({sensor, detections}); !used) report(…, used.error());
///   publish(tracker.truth());
class Tracker {
 public:
  /// Latest arrival [s] after the newest image: sensors differ by their exposure, transport and detection.
  static constexpr double kLatest = 0.2;

  /// Images and detections that were not used, since the beginning.
  struct Refused {
    std::uint64_t late = 0;        // images
    std::uint64_t repeated = 0;    // images
    std::uint64_t detections = 0;  // not finite, or no covariance, or too many
    std::uint64_t restarts = 0;    // of all tracks, after the sensors' clock was set back
  };

  /// At most kMostSensors sensors are used (asserted).
  explicit Tracker(std::vector<Sensor> sensors);

  /// Takes an image of a sensor. An image that comes late by up to kLatest counts as if it had come in time: the tracker
  /// returns to the scene before it and repeats the later images.
  /// Returns an Error for an unknown sensor, and for an image that has no time, is later than that, or came before.
  /// If 30 images in a row are too late, the clock was set back, and all tracks begin anew.
  Result<void> add(const SensorImage& image);

  /// Takes the place where a robot believes to be. It counts for images at most 0.15 s apart that come after it.
  /// Returns an Error if it is not valid, or there are more than kMostPlayers.
  Result<void> identify(const OwnPose& pose) { return poses_.add(pose); }

  /// Returns the truth at the newest image.
  FusedTruth truth() const { return truth_of(scene_); }

  const Refused& refused() const { return refused_; }

 private:
  struct Past {
    SensorImage image;
    TrackScene before;
  };

  Result<void> check(const SensorImage& image);
  void count_late();
  bool too_late(const SensorImage& image) const;
  auto past_end() { return past_.begin() + static_cast<std::ptrdiff_t>(past_count_); }
  void insert(const SensorImage& image);
  void forget_old();

  Fusion fusion_;
  OwnPoses poses_;
  TrackScene scene_;
  std::vector<std::unique_ptr<Past>> past_;  // the newest images, in the order of their times; the rest is spare
  std::size_t past_count_ = 0;
  std::uint64_t late_in_a_row_ = 0;
  Refused refused_;
};

}  // namespace robot::truth
