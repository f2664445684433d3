// The ball's filter: several paths that it may have taken, each with its probability.
#pragma once

#include <array>
#include <cstdint>

#include "robot/truth/tracks/estimate.h"

namespace robot::truth {

/// The explanation of a measurement: the ball rolled on, or it was kicked (or rebounded) since the last one, or the
/// measurement shows something else.
enum class BallEvent : std::uint8_t { rolled, kicked, not_a_ball };

/// Most paths at a time: the likely moments of a kick, and the doubt whether there was one. Each costs two predictions.
constexpr std::size_t kMostPaths = 6;

/// A small multiple-hypothesis filter. A kick is one sudden change of velocity, so that the filter follows it within two
/// images and still averages over many images while the ball rolls. One filter with more noise would do neither.
class BallPaths {
 public:
  struct Path {
    Estimate estimate;         // at the time of the newest measurement
    double log_weight = 0;     // the best path has 0
    BallEvent event{};         // its explanation of the newest measurement
    std::uint8_t parent = 0;   // the index of its beginning, before that measurement
    std::uint16_t recent = 0;  // its last kRemembered events, 2 bits each
  };

  BallPaths(const Measurement& first, const SharedErrors& shared);

  /// Reports whether the ball could be at this place `dt` [s] after the newest measurement, kicked or not.
  bool explains(const Measurement& measurement, const SharedErrors& shared, double dt) const;

  /// Takes a measurement that came `dt` [s] after the newest one.
  void advance(const Measurement& measurement, const SharedErrors& shared, double dt);

  /// Returns the mean and covariance of all paths.
  Estimate mixture() const;

  /// Returns the paths, the most likely one first. Only the first count() are in use.
  const std::array<Path, kMostPaths>& paths() const { return paths_; }
  std::size_t count() const { return count_; }

 private:
  std::array<Path, kMostPaths> paths_;
  std::size_t count_ = 1;
};

/// Returns the step of a ball to which this event happened in `dt` [s].
Step ball_event_step(const Estimate& ball, const SharedErrors& shared, double dt, BallEvent event);

}  // namespace robot::truth
