// What hides the device a stream goes to or comes from: a file, a local socket, a WebSocket.
#pragma once

#include <cstdint>
#include <limits>
#include <optional>
#include <string>

#include "robot/core/result.h"
#include "robot/logging/mcap/record.h"
#include "robot/logging/streams/version_queue.h"
#include "robot/memory/channel.h"

namespace robot::logging {

/// Where a logger takes the versions of one channel. Used by one thread.
class OutProvider {
 public:
  static constexpr std::uint64_t kNever = std::numeric_limits<std::uint64_t>::max();

  virtual ~OutProvider() = default;

  /// Opens the device for the channel `info`. Tried again later if it fails.
  virtual Result<void> open(const memory::ChannelInfo& info) = 0;

  /// Whether `version` is to be carried at all: what is not wanted takes no room in a queue. Called by the writer's
  /// thread for each version, in order; returns at once. What it remembers is its own.
  virtual bool wants(const memory::Version& /*version*/) { return true; }

  /// Takes one version; may block. On an Error this version is lost to the stream, later ones may succeed.
  virtual Result<void> write(const memory::VersionPtr& version) = 0;

  /// How long versions may gather before write() is called for them.
  virtual Patience patience() const { return {}; }

  /// When flush() is wanted at the latest [ns, monotonic]; kNever while nothing is held back.
  virtual std::uint64_t flush_due_ns() const { return kNever; }

  /// Hands what was held back to the device.
  virtual Result<void> flush() { return {}; }

  /// Ends the stream in good order. Nothing is written afterwards.
  virtual Result<void> close() = 0;

  /// How many messages write() took and the device lost afterwards. Any thread.
  virtual std::uint64_t lost_afterwards() const { return 0; }

  /// Ends a blocked write(); later ones fail at once. Any thread.
  virtual void cancel() {}
};

/// Where a parser gets the messages of one stream. Used by one thread, except `cancel`.
class InProvider {
 public:
  virtual ~InProvider() = default;

  /// Opens the device; what the stream says of itself.
  virtual Result<memory::ChannelInfo> open() = 0;

  /// The next message; nothing at the end of the stream or after cancel(). Blocks until there is one.
  /// An Error names a damage, once; the next call goes on behind it, or returns nothing where that cannot be.
  virtual Result<std::optional<Record>> read() = 0;

  /// Goes to another time: the next message is the newest captured at `capture_ns` or before, or the first of all if
  /// there is none. An Error where that cannot be.
  virtual Result<void> seek(std::uint64_t /*capture_ns*/) { return Error{"a stream that is live has no other times"}; }

  /// How many messages were lost on their way here, as far as the stream tells. Any thread.
  virtual std::uint64_t lost_before() const { return 0; }

  /// Ends a blocked read() and all later ones. Any thread.
  virtual void cancel() {}
};

}  // namespace robot::logging
