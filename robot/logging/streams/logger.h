// A logger: the thread that carries one memory object to a stream.
#pragma once

#include <cstddef>
#include <cstdint>
#include <memory>
#include <thread>

#include "robot/logging/streams/bell.h"
#include "robot/logging/streams/carrier.h"

namespace robot::logging {

/// A carrier with a thread of its own, so that a slow device delays no other stream. The thread starts with the first
/// version: an object that nobody writes costs no thread. If the system allows no more threads, the logger tries again once
/// a second; meanwhile its queue holds the versions, and those beyond it count as dropped.
class Logger final : public Sleeper {
 public:
  /// Starts at once with the newest version. The queue to a slow device holds at most `queue_bytes`. No writer wakes the
  /// thread: `bell` does. It must outlive the logger.
  Logger(std::shared_ptr<memory::Channel> channel, std::unique_ptr<OutProvider> provider, std::size_t queue_bytes,
         Bell& bell);

  /// As stop().
  ~Logger() override { stop(); }

  /// Closes the queue, writes the queued versions, closes the stream and ends the thread. A second call has no effect.
  void stop();

  StreamStatus status() const { return carrier_.status(); }

  /// Starts the thread, or wakes it.
  void ring(std::uint64_t now_ns) override;

 private:
  void run();

  Bell& bell_;
  Carrier carrier_;
  bool stopped_ = false;
  std::uint64_t next_try_ns_ = 0;  // [monotonic] of starting the thread
  std::thread thread_;             // declared last, because it uses the carrier
};

}  // namespace robot::logging
