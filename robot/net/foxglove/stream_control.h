// The streams of watched channels: each starts with its channel's first subscriber and stops with the last.
#pragma once

#include <cstdint>
#include <map>
#include <memory>
#include <string>

#include "robot/net/foxglove/inbox.h"
#include "robot/net/foxglove/streams.h"
#include "robot/net/foxglove/web_socket_out_provider.h"
#include "robot/net/foxglove/worker.h"

namespace robot::net {

/// The control of streams. It starts and stops them on a thread of its own, because a stop waits for the stream's
/// logger, which may wait for the I/O thread to empty the inbox. Used by the I/O thread.
class StreamControl {
 public:
  /// `streams` must outlive it.
  StreamControl(Streams& streams, std::shared_ptr<Inbox> inbox)
      : streams_(streams), inbox_(std::move(inbox)), worker_("net streams") {}

  /// As finish().
  ~StreamControl() { finish(); }

  /// Starts the thread. Returns an Error if the system allows no more threads.
  Result<void> start_thread() { return worker_.start(); }

  /// Carries `source` to the inbox as `channel`, converted by `derived` if that is given. Returns the stream's number.
  std::uint64_t start(std::uint32_t channel, std::shared_ptr<memory::Channel> source, const Derived* derived);

  void stop(std::uint64_t stream);

  /// Destroys `thing`, whose destruction may wait, on the thread that starts and stops streams.
  void discard(std::shared_ptr<void> thing);

  /// Stops all streams. Close the inbox before, because loggers may wait for room in it.
  void finish();

 private:
  Streams& streams_;
  const std::shared_ptr<Inbox> inbox_;
  std::uint64_t last_stream_ = 0;
  std::map<std::uint64_t, Streams::Id> running_;  // used only by the worker's thread
  Worker worker_;                                 // declared last, because its tasks use all other members
};

}  // namespace robot::net
