// Conversion of the times in messages from one machine's clock to another's.
#pragma once

#include <google/protobuf/dynamic_message.h>

#include <cstdint>
#include <memory>
#include <string>
#include <string_view>

#include "robot/core/clock_shift.h"
#include "robot/memory/channel.h"
#include "robot/memory/schema_pool.h"

namespace robot::memory {

/// A shift of all times in the messages of one channel. Used by one thread.
///
/// A time in our messages is a 64-bit unsigned integer in a field whose name ends in `_ns`. Durations and monotonic
/// times have such names too; they are told apart because they are not within a day of the message's capture time.
class TimeShift {
 public:
  /// Shifts every time. In a channel that is not protobuf or has no readable schema, no times can be found.
  TimeShift(const ChannelInfo& channel, const ClockShift& shift);

  std::uint64_t operator()(std::uint64_t time_ns) const { return shift_(time_ns); }

  /// Returns `bytes` with every time in it shifted. `capture_ns` is their capture time by the clock that wrote them.
  /// Bytes that do not match the schema are returned unchanged.
  std::string moved(std::string bytes, std::uint64_t capture_ns);

 private:
  bool move(google::protobuf::Message& message, std::uint64_t capture_ns) const;

  const ClockShift shift_;
  const std::unique_ptr<SchemaPool> schema_;
  google::protobuf::DynamicMessageFactory factory_;
  const google::protobuf::Message* prototype_ = nullptr;  // of the factory; null: no times to shift
};

}  // namespace robot::memory
