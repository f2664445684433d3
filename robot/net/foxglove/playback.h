// The playback of a recording, which clients may pause, seek and speed up.
#pragma once

#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <string_view>

#include "robot/core/result.h"
#include "robot/memory/channel.h"
#include "robot/net/foxglove/from_client.h"
#include "robot/net/foxglove/to_client.h"

namespace robot::net {

/// A playhead in a recording. Any thread; no function waits.
class Playhead {
 public:
  struct State {
    foxglove::Playback status = foxglove::Playback::playing;
    std::uint64_t time_ns = 0;  // capture time [ns since the epoch]
    float speed = 1;            // 1 is real time
  };

  virtual ~Playhead() = default;

  virtual State state() const = 0;

  /// Carries out a client's request, whose speed is already checked. Returns true if the playhead was moved.
  virtual bool control(const foxglove::PlaybackControl& wish) = 0;
};

/// The playhead of one client, which moves no other. Its destruction may wait for a read of the recording.
class OwnPlayhead : public Playhead {
 public:
  /// Plays the topic of `info` from now on into the returned channel, beginning with its value of now. Returns null if
  /// the recording does not have the topic.
  virtual std::shared_ptr<memory::Channel> watch(const memory::ChannelInfo& info) = 0;

  /// Ends one watch of `topic`.
  virtual void unwatch(const std::string& topic) = 0;

  /// Begins again if the end is reached and the recording is played in a loop. Returns true if it did.
  virtual bool loop() = 0;
};

/// The playback of a recording, which all clients without a playhead of their own share.
class Playback : public Playhead {
 public:
  /// Return the span of the recording [ns since the epoch].
  virtual std::uint64_t start_ns() const = 0;
  virtual std::uint64_t end_ns() const = 0;

  /// Returns another playhead in the recording. It is paused at `from_ns`, or at the start of the recording if that is
  /// absent or outside of it. Returns an Error if there are too many.
  virtual Result<std::unique_ptr<OwnPlayhead>> own_playhead(std::optional<std::uint64_t> from_ns) = 0;
};

/// Returns the message with the state of a playhead.
std::string playback_state(const Playhead& playhead, bool did_seek, std::string_view request_id);

}  // namespace robot::net
