// One channel of a robot that is relayed: its messages, numbered on where they are numbered anew.
#pragma once

#include <cstdint>
#include <memory>
#include <optional>
#include <string>

#include "robot/core/result.h"
#include "robot/memory/channel.h"
#include "robot/memory/time_shift.h"

namespace robot::lab {

/// What one message is, as it came.
struct Arrived {
  std::uint64_t capture_ns = 0;                // [ns since the epoch] by the robot's clock
  std::optional<memory::Published> published;  // as the robot has it; nothing: it does not tell
  std::string bytes;
};

/// Enters what comes of one channel of one robot into a channel of this process, over any number of connections and runs
/// of the robot. A message that comes twice, because a new connection begins with the newest one, enters once. Numbers go
/// on where the robot began anew, and a gap in them tells of messages that did not get here. Used by one thread.
class CarriedChannel {
 public:
  explicit CarriedChannel(std::shared_ptr<memory::RawChannel> to) : to_(std::move(to)) {}

  const memory::ChannelInfo& info() const { return to_->info(); }

  /// A connection begins: `new_run` if the robot was started since the last one; times are moved by `shift_ns`.
  void connected(bool new_run, std::int64_t shift_ns);

  /// Enters a message; how many were lost before it.
  std::uint64_t enter(Arrived message);

 private:
  bool is_known(const Arrived& message) const;

  const std::shared_ptr<memory::RawChannel> to_;
  std::unique_ptr<memory::TimeShift> shift_;
  std::int64_t shift_ns_ = 0;
  bool first_of_connection_ = true;
  std::uint64_t theirs_ = 0;  // number of the last message as the robot counts; 0: of this run none came
  bool began_ = false;        // a message came, in whatever run
  Arrived last_;              // without its bytes if it is numbered
};

}  // namespace robot::lab
