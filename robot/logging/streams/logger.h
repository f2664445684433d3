// A logger: the thread that carries one memory object out to a stream.
#pragma once

#include <cstdint>
#include <memory>
#include <string>
#include <thread>

#include "robot/core/lock.h"
#include "robot/logging/streams/bell.h"
#include "robot/logging/streams/provider.h"
#include "robot/logging/streams/version_queue.h"
#include "robot/memory/channel.h"

namespace robot::logging {

/// How one stream is doing.
struct StreamStatus {
  std::string topic;
  std::uint64_t messages = 0;      // handed to the device, or read from it
  std::uint64_t dropped = 0;       // lost: the queue was full, the device refused, or the stream says so
  std::uint64_t queued_bytes = 0;  // waiting now
  bool failing = false;            // the last attempt failed; `problem` says why
  bool ended = false;              // nothing more will come
  std::string problem;             // one sentence, empty while all is well
};

/// Carries every version of a channel that an OutProvider wants to it, on a thread of its own, until stopped.
/// A device that fails is tried again with the next version; what it refused is counted as dropped.
class Logger {
 public:
  /// Starts at once, with the newest version there is. At most `queue_bytes` wait while the device is slow.
  /// With a `bell`, which outlives the logger, no writer ever wakes its thread.
  Logger(std::shared_ptr<memory::Channel> channel, std::unique_ptr<OutProvider> provider, std::size_t queue_bytes,
         Bell* bell = nullptr);

  /// As stop().
  ~Logger();

  /// Takes in nothing more, hands on what is queued, closes the stream and ends the thread.
  void stop();

  StreamStatus status() const;

 private:
  /// Lets into the queue what the provider wants.
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

  void run();
  void write(const memory::VersionPtr& version);
  bool open();
  bool succeeded(const Result<void>& outcome);

  const std::shared_ptr<memory::Channel> channel_;
  const std::unique_ptr<OutProvider> provider_;
  Bell* const bell_;
  VersionQueue queue_;
  Gate gate_;
  bool open_ = false;               // used by the thread alone
  std::uint64_t next_open_ns_ = 0;  // [monotonic], likewise

  mutable Mutex lock_;  // guards status_
  StreamStatus status_;
  std::thread thread_;  // last: it uses all the others
};

}  // namespace robot::logging
