#include "robot/truth/tracks/tracker.h"

#include <algorithm>
#include <cassert>
#include <utility>

#include "robot/core/text.h"
#include "robot/truth/tracks/times.h"
#include "robot/truth/tracks/usable.h"

namespace robot::truth {
namespace {

constexpr std::size_t kMostPast = 64;        // images: four sensors with 60 images a second
constexpr std::uint64_t kClockSetBack = 30;  // late images in a row

/// Returns the order of images: by time, then by sensor.
std::pair<std::uint64_t, std::size_t> order_of(const SensorImage& image) {
  return {image.detections.capture_ns, image.sensor};
}

}  // namespace

Tracker::Tracker(std::vector<Sensor> sensors) : fusion_(std::move(sensors)), past_(kMostPast) {
  assert(fusion_.sensors().size() <= kMostSensors);
  for (std::unique_ptr<Past>& past : past_) past = std::make_unique<Past>();
}

bool Tracker::too_late(const SensorImage& image) const {
  if (past_count_ == 0) return false;
  const bool forgotten = image.detections.capture_ns < past_.front()->before.now_ns;
  return forgotten || seconds_between(image.detections.capture_ns, scene_.now_ns) > kLatest;
}

void Tracker::count_late() {
  ++refused_.late;
  if (++late_in_a_row_ < kClockSetBack) return;
  ++refused_.restarts;
  late_in_a_row_ = 0;
  past_count_ = 0;
  scene_ = restarted(scene_);
}

Result<void> Tracker::check(const SensorImage& image) {
  if (const Result<void> checked = check_image(image, fusion_.sensors().size()); !checked) return checked.failure();
  if (too_late(image)) {
    const double age = seconds_between(image.detections.capture_ns, scene_.now_ns);
    count_late();
    return Error{formatted("sensor %zu: an image came %.2f s after a newer one, expected at most %.1f s",
                           image.sensor + 1, age, kLatest)};
  }
  late_in_a_row_ = 0;
  const auto same = [&](const auto& past) { return order_of(past->image) == order_of(image); };
  if (std::any_of(past_.begin(), past_end(), same)) {
    ++refused_.repeated;
    return Error{formatted("sensor %zu: the image of %.3f s came twice", image.sensor + 1,
                           1e-9 * static_cast<double>(image.detections.capture_ns))};
  }
  return {};
}

/// Makes images spare that no late image can precede, and at least one place.
void Tracker::forget_old() {
  auto keep = std::find_if(past_.begin(), past_end(), [&](const auto& past) {
    return seconds_between(past->image.detections.capture_ns, scene_.now_ns) <= kLatest;
  });
  if (keep == past_.begin() && past_count_ == past_.size()) ++keep;
  past_count_ -= static_cast<std::size_t>(keep - past_.begin());
  std::rotate(past_.begin(), keep, past_.end());
}

void Tracker::insert(const SensorImage& image) {
  forget_old();
  const auto at = std::find_if(past_.begin(), past_end(),
                               [&](const auto& past) { return order_of(image) < order_of(past->image); });
  if (at != past_end()) scene_ = (*at)->before;

  // a spare place moves to its position
  (*past_end())->image = image;
  std::rotate(at, past_end(), past_end() + 1);
  ++past_count_;
  for (auto past = at; past != past_end(); ++past) {
    (*past)->before = scene_;
    fusion_.advance(scene_, (*past)->image, poses_);
  }
}

Result<void> Tracker::add(const SensorImage& image) {
  if (const Result<void> checked = check(image); !checked) return checked.failure();
  insert({image.sensor, usable(image.detections, refused_.detections)});
  return {};
}

}  // namespace robot::truth
