// A logger: the thread that carries one memory object to a stream.
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

/// The status of one stream.
struct StreamStatus {
  std::string topic;
  std::uint64_t messages = 0;      // written to the device, or read from it
  std::uint64_t dropped = 0;       // lost: the queue was full, the device refused them, or the stream reports a loss
  std::uint64_t queued_bytes = 0;  // in the queue now
  bool failing = false;            // the last attempt failed; `problem` gives the reason
  bool ended = false;              // no more messages will follow
  std::string problem;             // one sentence, or empty without a problem
};

/// A thread that hands to an OutProvider every version of a channel that the provider wants, until it is stopped.
/// After a failure of the device the logger tries again with the next version. Refused versions count as dropped.
class Logger {
 public:
  /// Starts at once with the newest version. The queue to a slow device holds at most `queue_bytes`.
  /// With a `bell`, no writer wakes the logger's thread. The bell must outlive the logger.
  Logger(std::shared_ptr<memory::Channel> channel, std::unique_ptr<OutProvider> provider, std::size_t queue_bytes,
         Bell* bell = nullptr);

  /// As stop().
  ~Logger();

  /// Closes the queue, writes the queued versions, closes the stream and ends the thread.
  void stop();

  StreamStatus status() const;

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

  void run();
  void write(const memory::VersionPtr& version);
  bool open();
  bool succeeded(const Result<void>& outcome);

  const std::shared_ptr<memory::Channel> channel_;
  const std::unique_ptr<OutProvider> provider_;
  Bell* const bell_;
  VersionQueue queue_;
  Gate gate_;
  bool open_ = false;               // used only by the logger's thread
  std::uint64_t next_open_ns_ = 0;  // [ns, monotonic] used only by the logger's thread

  mutable Mutex lock_;  // guards status_
  StreamStatus status_;
  std::thread thread_;  // declared last, because it uses all other members
};

}  // namespace robot::logging
