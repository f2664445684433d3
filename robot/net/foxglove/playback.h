// The playback of a recording, which clients may pause, seek and speed up.
#pragma once

#include <cstdint>

#include "robot/net/foxglove/from_client.h"
#include "robot/net/foxglove/to_client.h"

namespace robot::net {

/// The playback of a recording. Any thread; no function waits.
class Playback {
 public:
  struct State {
    foxglove::Playback status = foxglove::Playback::playing;
    std::uint64_t time_ns = 0;  // capture time [ns since the epoch]
    float speed = 1;            // 1 is real time
  };

  virtual ~Playback() = default;

  /// Return the span of the recording [ns since the epoch].
  virtual std::uint64_t start_ns() const = 0;
  virtual std::uint64_t end_ns() const = 0;

  virtual State state() const = 0;

  /// Carries out a client's request, whose speed is already checked. Returns true if the playhead was moved.
  virtual bool control(const foxglove::PlaybackControl& wish) = 0;
};

}  // namespace robot::net
