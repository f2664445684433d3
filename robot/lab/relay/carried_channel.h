// One relayed channel of a robot, with sequence numbers that continue over connections and restarts.
#pragma once

#include <cstdint>
#include <memory>
#include <optional>
#include <string>

#include "robot/core/result.h"
#include "robot/memory/channel.h"
#include "robot/memory/time_shift.h"

namespace robot::lab {

/// One message as it arrived.
struct Arrived {
  std::uint64_t capture_ns = 0;                // [ns since the epoch] by the robot's clock
  std::optional<memory::Published> published;  // by the robot; nothing if the robot does not number its messages
  std::string bytes;
};

/// The path of one robot's channel into a channel of this process, over any number of connections and runs of the
/// robot. A message that arrives twice, because a new connection begins with the newest message, is written once.
/// Sequence numbers continue after a restart of the robot. A gap in them means lost messages. Used by one thread.
class CarriedChannel {
 public:
  explicit CarriedChannel(std::shared_ptr<memory::RawChannel> to) : to_(std::move(to)) {}

  const memory::ChannelInfo& info() const { return to_->info(); }

  /// Begins a connection. `new_run`: the robot was restarted since the last one. `shift_ns` is added to all times.
  void connected(bool new_run, std::int64_t shift_ns);

  /// Writes a message to the channel. Returns the number of messages that were lost before it.
  std::uint64_t enter(Arrived message);

 private:
  bool is_known(const Arrived& message) const;

  const std::shared_ptr<memory::RawChannel> to_;
  std::unique_ptr<memory::TimeShift> shift_;
  std::int64_t shift_ns_ = 0;
  bool first_of_connection_ = true;
  std::uint64_t theirs_ = 0;  // sequence number of the last message by the robot; 0: none in this run
  bool began_ = false;        // a message has arrived, in any run
  Arrived last_;              // without its bytes if it is numbered
};

}  // namespace robot::lab
