#include "robot/truth/sensor/live_source.h"

#include <chrono>
#include <thread>

namespace robot::truth {

void Waiting::rest_until_ns(std::uint64_t time_ns) {
  const std::uint64_t now_ns = monotonic_ns();
  if (time_ns > now_ns) std::this_thread::sleep_for(std::chrono::nanoseconds(time_ns - now_ns));
}

Result<std::optional<DepthFrame>> LiveSource::next() {
  if (!open_) {
    waiting_.rest_until(try_again_ns_);
    if (const Result<void> opened = driver_->open(); !opened) return lost(opened.failure());
    open_ = true;
    silent_s_ = 0;
  }
  Result<std::optional<DepthFrame>> frame = within_a_second();
  if (!frame) return lost(frame.failure());
  if (!*frame) return silent();
  silent_s_ = 0;
  if (const Result<void> applied = apply(camera_, **frame); !applied) return lost(applied.failure());
  return frame;
}

/// Returns an image of the open sensor, or nothing if none came for a second.
Result<std::optional<DepthFrame>> LiveSource::within_a_second() {
  const std::uint64_t end_ns = waiting_.now_ns() + kSecond;
  for (std::uint64_t now_ns = end_ns - kSecond; now_ns < end_ns; now_ns = waiting_.now_ns()) {
    const auto patience_ms = static_cast<int>((end_ns - now_ns + kMillisecond - 1) / kMillisecond);
    Result<std::optional<DepthFrame>> frame = driver_->newest(patience_ms);
    if (!frame || *frame) return frame;
  }
  return std::optional<DepthFrame>();
}

/// Closes the sensor until it is tried again. Returns the sentence for the person.
Error LiveSource::lost(const Error& reason) {
  driver_->close();
  open_ = false;
  try_again_ns_ = waiting_.now_ns() + kSecond;
  return Error{address_ + ": " + reason.sentence};
}

/// Counts a second without an image.
Error LiveSource::silent() {
  const Error sentence{"the sensor sends no images"};
  if (++silent_s_ >= kPatience) return lost(sentence);
  return Error{address_ + ": " + sentence.sentence};
}

}  // namespace robot::truth
