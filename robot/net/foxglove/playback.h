// A recording that clients may pause and move about in.
#pragma once

#include <cstdint>

#include "robot/net/foxglove/from_client.h"
#include "robot/net/foxglove/to_client.h"

namespace robot::net {

/// Any thread; nothing of it waits.
class Playback {
 public:
  struct State {
    foxglove::Playback status = foxglove::Playback::playing;
    std::uint64_t time_ns = 0;  // capture time [ns since the epoch]
    float speed = 1;            // 1 is real time
  };

  virtual ~Playback() = default;

  /// The span of the recording [ns since the epoch].
  virtual std::uint64_t start_ns() const = 0;
  virtual std::uint64_t end_ns() const = 0;

  virtual State state() const = 0;

  /// Does what a client asks for; its speed is sound. True if playback goes on at another time.
  virtual bool control(const foxglove::PlaybackControl& wish) = 0;
};

}  // namespace robot::net
