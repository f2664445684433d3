// The history of the sightings of one thing: its birth, its number, its sensors.
#pragma once

#include <array>
#include <cstdint>

#include "robot/truth/tracks/disagreement.h"

namespace robot::truth {

/// Images that must show a new thing before it is one, of five in a row: no more than two in between may miss it.
constexpr std::uint32_t kBirthHits = 3, kBirthMisses = 2;

/// The history of the sightings of one thing.
struct Sightings {
  std::uint32_t serial = 0;      // from 1, unique for robots and balls together
  std::uint32_t track = 0;       // from 1; 0: not confirmed yet
  std::uint32_t hits = 0;        // images that showed it
  std::uint32_t misses = 0;      // images of the first sensor that did not; only before it is confirmed
  std::size_t first_sensor = 0;  // the one that found it
  std::array<std::uint64_t, kMostSensors> seen_ns{};  // newest image of each sensor that showed it; 0: none
  std::uint64_t newest_ns = 0;                        // of these
  Measurement newest;                                 // in that image
  SharedErrors shared = no_errors();                  // at its place
  Disagreement disagreement;

  /// Begins the history with a measurement that belongs to no other thing.
  static Sightings begun(std::uint32_t serial, const Measurement& measurement, const SharedErrors& errors,
                         std::uint64_t capture_ns);

  /// Takes one more measurement of a thing with this velocity [m/s], and the shared errors at its place.
  void see(const Measurement& measurement, const SharedErrors& errors, const Eigen::Vector2d& velocity,
           std::uint64_t capture_ns);

  /// Counts an image that does not show it.
  void miss(std::size_t sensor) { misses += track == 0 && sensor == first_sensor; }

  bool proved() const { return hits >= kBirthHits; }

  /// Reports whether the thing is no longer expected to come back.
  bool lost(std::uint64_t now_ns) const;
};

}  // namespace robot::truth
