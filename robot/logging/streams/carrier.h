// A stream out of memory: a channel, a queue and a provider.
#pragma once

#include <cstddef>
#include <cstdint>
#include <functional>
#include <memory>

#include "robot/core/lock.h"
#include "robot/logging/streams/provider.h"
#include "robot/logging/streams/stream_status.h"
#include "robot/logging/streams/version_queue.h"
#include "robot/memory/channel.h"

namespace robot::logging {

/// A queue from a channel to an OutProvider, without a thread. It collects every version that the provider wants,
/// beginning with the newest version of the channel. After a failure of the device it tries again with the next version,
/// but opens the device at most once a second. Refused versions count as dropped. The status is failing until the device
/// has taken everything that the provider holds.
///
/// After finish() each version that the channel wrote between attach() and detach(), and that the provider wanted, is
/// counted once: as a message on the device or as dropped.
///
/// One thread at a time may call carry() and finish().
class Carrier {
 public:
  /// The queue holds at most `queue_bytes`. Versions arrive after attach().
  Carrier(std::shared_ptr<memory::Channel> channel, std::unique_ptr<OutProvider> provider, std::size_t queue_bytes);
  ~Carrier() { detach(); }

  /// Begins to collect versions.
  void attach() { channel_->attach(gate_); }

  /// Accepts no more versions, ends a blocked write(), and wakes a waiting carry(). Any thread.
  void detach();

  /// Returns whether queued versions have waited long enough at `now_ns` [monotonic]. Does not wait. Any thread.
  bool due(std::uint64_t now_ns) { return queue_.due(now_ns); }

  /// Wakes a waiting carry(). Any thread.
  void wake() { queue_.wake(); }

  /// Waits for a version, but not beyond the provider's next flush; writes it, and flushes if a flush is due.
  /// Returns false when detach() was called and the queue is empty.
  bool carry();

  /// Writes the next version if one is queued. Returns whether more are queued.
  bool carry_queued();

  /// Writes the queued versions and closes the device. A device that was never opened is opened first, so that an unused
  /// stream leaves an empty file. Call detach() before.
  void finish();

  StreamStatus status() const;
  const memory::ChannelInfo& info() const { return channel_->info(); }

 private:
  /// The listener that puts into the queue only the versions that the provider wants.
  class Gate final : public memory::Listener {
   public:
    Gate(OutProvider& provider, VersionQueue& queue) : provider_(provider), queue_(queue) {}
    void on_version(const memory::VersionPtr& version) override {
      if (provider_.wants(*version)) queue_.on_version(version);
    }

   private:
    OutProvider& provider_;
    VersionQueue& queue_;
  };

  void write(const memory::VersionPtr& version);
  bool open();
  bool succeeds(const std::function<Result<void>()>& call);

  const std::shared_ptr<memory::Channel> channel_;
  const std::unique_ptr<OutProvider> provider_;
  VersionQueue queue_;
  Gate gate_;
  bool open_ = false;
  std::uint64_t next_open_ns_ = 0;  // [ns, monotonic]

  mutable Mutex lock_;  // guards the next two
  StreamStatus status_;
  std::uint64_t buffered_ = 0;  // messages in the provider's buffer after its last call
};

}  // namespace robot::logging
