// Messages of a machine whose clock is ahead or behind, told in another clock's time.
#pragma once

#include <google/protobuf/dynamic_message.h>

#include <cstdint>
#include <memory>
#include <string>
#include <string_view>

#include "robot/memory/channel.h"
#include "robot/memory/schema_pool.h"

namespace robot::memory {

/// Moves the times within the messages of one channel. As everywhere in our messages a time is a whole number of 64 bits
/// in a field that ends in `_ns`; a duration or a monotonic time, which may be called the same, is not within a day of
/// when its message was captured. Used by one thread.
class TimeShift {
 public:
  /// `by_ns` is added to every time. What is no protobuf with a readable schema has no times that could be found.
  TimeShift(const ChannelInfo& channel, std::int64_t by_ns);

  std::uint64_t operator()(std::uint64_t time_ns) const { return time_ns + static_cast<std::uint64_t>(by_ns_); }

  /// `bytes`, captured at `capture_ns` by the clock that wrote them, with every time in it moved. Bytes that are not of
  /// the schema stay as they are.
  std::string moved(std::string bytes, std::uint64_t capture_ns);

 private:
  bool move(google::protobuf::Message& message, std::uint64_t capture_ns) const;

  const std::int64_t by_ns_;
  const std::unique_ptr<SchemaPool> schema_;
  google::protobuf::DynamicMessageFactory factory_;
  const google::protobuf::Message* prototype_ = nullptr;  // of the factory; null: there is nothing to move
};

}  // namespace robot::memory
