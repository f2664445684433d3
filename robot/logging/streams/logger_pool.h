// A few threads that carry many memory objects to streams.
#pragma once

#include <cstddef>
#include <cstdint>
#include <deque>
#include <memory>
#include <thread>
#include <vector>

#include "robot/core/lock.h"
#include "robot/logging/streams/bell.h"
#include "robot/logging/streams/carrier.h"

namespace robot::logging {

/// Carriers that share kThreads threads. A thread writes one version of a stream and then turns to the next stream, so
/// that a stream of images delays no small one for longer than one image. The versions of one stream stay in order.
///
/// One thread does all the work while it keeps up with the bell; another joins it when versions of the last ring still
/// wait. The threads start with the first stream; those that the system refuses are tried again with each further stream and
/// by start_missing_threads(). The pool never calls OutProvider::flush(). It is for devices without a
/// buffer that are all slow together, such as the server. A disk or a door has a Logger for each object. Any thread.
class LoggerPool final : public Sleeper {
 public:
  static constexpr std::size_t kThreads = 3;

  /// `bell` must outlive the pool.
  explicit LoggerPool(Bell& bell) : bell_(bell) {}

  /// Ends the threads. All streams must have ended.
  ~LoggerPool() override;
  LoggerPool(const LoggerPool&) = delete;
  LoggerPool& operator=(const LoggerPool&) = delete;

  /// A stream of the pool.
  class Stream {
   public:
    /// Begins with the newest version of `channel`. The queue to a slow device holds at most `queue_bytes`.
    Stream(LoggerPool& pool, std::shared_ptr<memory::Channel> channel, std::unique_ptr<OutProvider> provider,
           std::size_t queue_bytes);
    ~Stream() { stop(); }
    Stream(const Stream&) = delete;
    Stream& operator=(const Stream&) = delete;

    /// Closes the queue, writes the queued versions and closes the stream. A second call has no effect.
    void stop();

    StreamStatus status() const { return carrier_.status(); }

   private:
    friend class LoggerPool;

    LoggerPool& pool_;
    Carrier carrier_;
    bool stopped_ = false;
    enum class State { resting, ready, busy } state_ = State::resting;  // guarded by the pool
  };

  /// Starts the threads that the system refused before.
  void start_missing_threads();

  /// Makes the streams ready that are due, and wakes a thread for them.
  void ring(std::uint64_t now_ns) override;

 private:
  void add(Stream& stream);
  void remove(Stream& stream);
  void start_threads();
  void run();

  Bell& bell_;
  Mutex lock_;
  Condition work_, done_;
  std::vector<Stream*> streams_;
  std::deque<Stream*> ready_;
  std::size_t busy_ = 0;  // streams whose version is being written
  bool behind_ = false;   // streams of the last ring still wait
  bool rung_ = false;     // the bell knows the pool
  bool ended_ = false;
  std::vector<std::thread> threads_;
};

}  // namespace robot::logging
