// Which channels are being carried to the server: started with their first subscriber, stopped with their last.
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

/// Starts and stops streams on a thread of its own: stopping waits for a logger thread, which may be waiting for the
/// I/O thread to empty the inbox. Used by the I/O thread.
class StreamControl {
 public:
  /// `streams` outlives it.
  StreamControl(Streams& streams, std::shared_ptr<Inbox> inbox)
      : streams_(streams), inbox_(std::move(inbox)), worker_("net streams") {}

  /// As finish().
  ~StreamControl() { finish(); }

  /// Carries `source`, or what `derived` makes of it, to the inbox as `channel`. Returns the number of the stream.
  std::uint64_t start(std::uint32_t channel, std::shared_ptr<memory::Channel> source, const Derived* derived);

  void stop(std::uint64_t stream);

  /// Stops all streams. The inbox is closed before, or nobody empties it for the loggers that wait.
  void finish();

 private:
  Streams& streams_;
  const std::shared_ptr<Inbox> inbox_;
  std::uint64_t last_stream_ = 0;
  std::map<std::uint64_t, Streams::Id> running_;  // used by the worker's thread alone
  Worker worker_;                                 // last: its tasks use all the others
};

}  // namespace robot::net
