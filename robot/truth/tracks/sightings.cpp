#include "robot/truth/tracks/sightings.h"

#include "robot/truth/tracks/gates.h"
#include "robot/truth/tracks/times.h"

namespace robot::truth {
namespace {

constexpr double kLongestBirth = 2;  // [s] between two sightings of a new thing

}  // namespace

Sightings Sightings::begun(std::uint32_t serial, const Measurement& measurement, const SharedErrors& errors,
                           std::uint64_t capture_ns) {
  Sightings sightings;
  sightings.serial = serial;
  sightings.first_sensor = measurement.sensor;
  sightings.see(measurement, errors, Eigen::Vector2d::Zero(), capture_ns);
  return sightings;
}

void Sightings::see(const Measurement& measurement, const SharedErrors& errors, const Eigen::Vector2d& velocity,
                    std::uint64_t capture_ns) {
  ++hits;
  misses = 0;
  seen_ns[measurement.sensor] = capture_ns;
  newest_ns = capture_ns;
  newest = measurement;
  shared = errors;
  disagreement.compare(measurement, errors[measurement.sensor], velocity, capture_ns);
}

bool Sightings::lost(std::uint64_t now_ns) const {
  const double unseen = seconds_between(newest_ns, now_ns);
  return track != 0 ? unseen > kLongestOcclusion : unseen > kLongestBirth || misses > kBirthMisses;
}

}  // namespace robot::truth
