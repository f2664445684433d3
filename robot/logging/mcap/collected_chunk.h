// The messages of one channel between write() and their chunk in the file.
#pragma once

#include <algorithm>
#include <cstdint>
#include <limits>
#include <string>

#include "robot/logging/mcap/format.h"

namespace robot::logging::mcap {

/// The next chunk of one channel, while its messages arrive.
struct CollectedChunk {
  static constexpr std::uint64_t kNever = std::numeric_limits<std::uint64_t>::max();

  std::string records;                     // the encoded messages
  MessageIndex index;                      // of them; with the channel's id
  std::uint64_t start_ns = 0, end_ns = 0;  // [ns since the epoch] least and greatest log_time
  std::uint64_t due_ns = kNever;           // latest time for the write, on the writer's clock

  bool empty() const { return index.entries.empty(); }

  /// Makes room for one more message of `data_bytes`, so that add_head() and the data allocate nothing. If there is no
  /// memory, it throws and changes nothing.
  void make_room(std::uint64_t data_bytes) {
    constexpr std::size_t kHeadBytes = 64;  // of a record and its message, rounded up
    if (index.entries.size() == index.entries.capacity())
      index.entries.reserve(std::max<std::size_t>(64, 2 * index.entries.size()));
    records.reserve(records.size() + kHeadBytes + data_bytes);
  }

  /// Appends `message`, which is still without its data, and enters it into the index. The caller appends the
  /// `data_bytes` of data to `records`, or writes them to the file directly after `records`.
  void add_head(const Message& message, std::uint64_t data_bytes) {
    start_ns = empty() ? message.log_time : std::min(start_ns, message.log_time);
    end_ns = empty() ? message.log_time : std::max(end_ns, message.log_time);
    index.entries.emplace_back(message.log_time, records.size());
    append(records, message, data_bytes);
  }

  /// Forgets the messages and keeps the memory for the next ones.
  void clear() {
    records.clear();
    index.entries.clear();
    due_ns = kNever;
  }
};

}  // namespace robot::logging::mcap
