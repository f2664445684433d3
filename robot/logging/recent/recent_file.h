// An MCAP file in memory that forgets its oldest chunks.
#pragma once

#include <cstddef>
#include <cstdint>
#include <deque>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "robot/core/byte_source.h"
#include "robot/core/clock.h"
#include "robot/core/result.h"
#include "robot/logging/mcap/writer.h"
#include "robot/memory/channel.h"

namespace robot::logging {

/// The bounds of a recent file.
struct RecentLimits {
  std::uint64_t age_ns = 300 * kSecond;   // capture time before the newest message of all channels
  std::size_t bytes = 6'000'000;          // of all chunks, compressed
  std::size_t chunk_bytes = 64 * 1024;    // of the messages that wait for compression, of each channel
  std::uint64_t chunk_ns = 10 * kSecond;  // capture time of the messages of a chunk
};

/// The messages of the last minutes, compressed. When it is full, it forgets the oldest chunk that is not the only one of its
/// channel. So the newest value of an object that is rarely written stays. A channel whose capture times go back by more
/// than a second begins anew, as after the restart of a simulated game. Used by one thread at a time.
class RecentFile {
 public:
  explicit RecentFile(const RecentLimits& limits = {}) : limits_(limits) {}
  RecentFile(const RecentFile&) = delete;
  RecentFile& operator=(const RecentFile&) = delete;

  /// Adds a channel and returns its number. Channels stay for ever.
  std::size_t add(memory::ChannelInfo info);

  /// Takes a message of that channel. After an Error it is lost.
  Result<void> write(std::size_t channel, const OutMessage& message);

  /// Returns all messages, or those of `topics`, as one MCAP file, which later calls do not change.
  Result<std::shared_ptr<const ByteSource>> file(std::span<const std::string> topics = {});

  std::size_t size_bytes() const { return store_.bytes; }  // of the chunks

 private:
  /// A chunk with its index, as the writer appended both.
  struct Chunk {
    std::size_t channel;
    std::uint64_t end_ns;  // the greatest capture time
    std::string bytes;
  };
  struct Store {
    std::string head;
    std::deque<Chunk> chunks;  // in the order of writing
    std::size_t bytes = 0;     // of the chunks
    std::size_t since_open = 0;
  };
  class Sink;

  Result<void> open();
  Result<void> flush();
  Result<void> begin_anew(std::size_t channel);
  void forget_old();

  const RecentLimits limits_;
  std::vector<memory::ChannelInfo> channels_;
  std::vector<std::uint64_t> newest_ns_;  // capture time, of each channel; 0: none yet
  Store store_;
  std::optional<McapWriter> writer_;  // of the first channels; empty before the first message
  std::size_t open_channels_ = 0;     // that the writer has
};

}  // namespace robot::logging
