// The thread that writes the worlds of an SSL-Vision as the object /truth/world.
#pragma once

#include <atomic>
#include <thread>

#include "proto/foresight/truth.pb.h"
#include "robot/core/clock.h"
#include "robot/core/result.h"
#include "robot/memory/memory_object.h"
#include "robot/truth/feeds/ssl_vision_feed.h"

namespace robot::app {

/// A second without a packet is a warning in the log, and the packets come back by themselves.
class FeedWatch {
 public:
  /// `clock` and `world` outlive this.
  FeedWatch(truth::SslVisionFeed feed, const Clock& clock, memory::MemoryObject<foresight::GroundTruth>& world)
      : feed_(std::move(feed)), clock_(clock), world_(world) {}
  ~FeedWatch() { stop(); }

  /// Starts the thread, once. Returns an Error if the system allows no more threads.
  Result<void> start();

  /// Ends the thread within a second. A second call has no effect.
  void stop();

 private:
  void run();

  truth::SslVisionFeed feed_;
  const Clock& clock_;
  memory::MemoryObject<foresight::GroundTruth>& world_;
  std::atomic<bool> stopping_ = false;
  std::thread thread_;  // last, because it uses all the others
};

}  // namespace robot::app
