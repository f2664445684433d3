// A limit of versions per second.
#pragma once

#include <cstdint>

namespace robot::net {

/// A limit of versions per second of capture time, so that playback at double speed shows as many images.
class RateLimit {
 public:
  bool passes(std::uint64_t capture_ns, double rate_hz) {
    const auto period_ns = static_cast<std::uint64_t>(1e9 / rate_hz);
    // a camera's times jitter: an image that is a little early passes; a jump back starts the limit anew
    const bool early = capture_ns >= last_ns_ && capture_ns - last_ns_ + period_ns / 4 < period_ns;
    if (last_ns_ != 0 && early) return false;
    last_ns_ = capture_ns;
    return true;
  }

 private:
  std::uint64_t last_ns_ = 0;
};

}  // namespace robot::net
