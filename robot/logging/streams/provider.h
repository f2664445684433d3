// Interfaces to the device of a stream: a file, a local socket or a WebSocket.
#pragma once

#include <cstdint>
#include <functional>
#include <limits>
#include <memory>
#include <optional>
#include <string>

#include "robot/core/result.h"
#include "robot/logging/mcap/record.h"
#include "robot/logging/streams/version_queue.h"
#include "robot/memory/channel.h"

namespace robot::logging {

/// The destination of one channel's versions; a logger writes to it. Used by one thread, except where noted.
class OutProvider {
 public:
  static constexpr std::uint64_t kNever = std::numeric_limits<std::uint64_t>::max();

  virtual ~OutProvider() = default;

  /// Opens the device for the channel `info`. After an Error the logger calls it again later.
  virtual Result<void> open(const memory::ChannelInfo& info) = 0;

  /// Returns whether the logger must carry `version`. Unwanted versions take no room in the queue. The thread of the
  /// channel's writer calls it for each version, in order, so it must not block. No other function may use its state.
  virtual bool wants(const memory::Version& /*version*/) { return true; }

  /// Writes one version; may block. After an Error the stream has lost this version; later ones may succeed.
  virtual Result<void> write(const memory::VersionPtr& version) = 0;

  /// Returns how long versions may collect before the logger calls write() for them.
  virtual Patience patience() const { return {}; }

  /// Returns the latest time for the next flush() [ns, monotonic], or kNever while the buffer is empty.
  virtual std::uint64_t flush_due_ns() const { return kNever; }

  /// Writes the buffer to the device.
  virtual Result<void> flush() { return {}; }

  /// Completes and closes the stream. No write() follows.
  virtual Result<void> close() = 0;

  /// Returns how many messages of successful calls of write() are still in the buffer.
  virtual std::uint64_t buffered() const { return 0; }

  /// Returns how many messages the device lost after a successful write(). Any thread.
  virtual std::uint64_t lost_afterwards() const { return 0; }

  /// Ends a blocked write(). Later ones fail at once. Any thread.
  virtual void cancel() {}
};

/// The source of one stream's messages; a parser reads from it. Used by one thread, except where noted.
class InProvider {
 public:
  virtual ~InProvider() = default;

  /// Opens the device. Returns the stream's own description of its channel.
  virtual Result<memory::ChannelInfo> open() = 0;

  /// Waits for the next message and returns it, or nothing at the end of the stream or after cancel().
  /// Returns an Error once for each damage. The next call continues after the damage, or returns nothing if it cannot.
  virtual Result<std::optional<Record>> read() = 0;

  /// Moves to another time. The next message is then the newest captured at `capture_ns` or before, or without one, the
  /// first of the stream. Returns an Error if the stream cannot seek.
  virtual Result<void> seek(std::uint64_t /*capture_ns*/) { return Error{"a stream that is live has no other times"}; }

  /// Returns how many messages were lost before they arrived here, as far as the stream reports it. Any thread.
  virtual std::uint64_t lost_before() const { return 0; }

  /// Ends a blocked read() and all later ones. Any thread.
  virtual void cancel() {}
};

/// Returns a new stream of a topic, not opened yet, or null if the recording does not have the topic. The caller owns
/// it.
using StreamOf = std::function<std::unique_ptr<InProvider>(const std::string& topic)>;

}  // namespace robot::logging
