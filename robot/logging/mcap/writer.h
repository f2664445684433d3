// Writes one channel into an MCAP file, so that whoever pulls the plug loses one second at most.
#pragma once

#include <cstdint>
#include <limits>
#include <map>
#include <memory>
#include <string>
#include <string_view>

#include "robot/core/byte_sink.h"
#include "robot/core/clock.h"
#include "robot/core/result.h"
#include "robot/logging/mcap/compression.h"
#include "robot/logging/mcap/format.h"
#include "robot/logging/mcap/summary.h"
#include "robot/memory/channel.h"

namespace robot::logging {

/// What is written about a session: records by name, each with its entries.
using MetadataByName = std::map<std::string, std::map<std::string, std::string>>;

struct McapOptions {
  std::uint16_t channel_id = 1;  // unique within a session
  MetadataByName metadata;
  std::string library = "foresight";  // the program that writes, and its version
  Compression compression = Compression::none;
  std::size_t chunk_bytes = 256 * 1024;   // a chunk is written when it has so many bytes,
  std::uint64_t chunk_time_ns = kSecond;  // or when its first message is so old
};

/// One message to be written. `bytes` need to live only as long as the call.
struct OutMessage {
  std::uint64_t sequence = 0;  // the file keeps the lower 32 bits
  std::uint64_t capture_ns = 0, publish_ns = 0;
  std::string_view bytes;
};

/// A recording of one channel. What the file says of itself is written at once; messages are collected into chunks, and
/// each chunk is written with its index in one go. A writer that is destroyed without close() leaves a file like one
/// whose process was killed: everything up to the last chunk can be read.
///
/// When writing fails, the file is cut back to its last good end, the messages of that chunk are lost and counted,
/// and the next ones are tried again: a disk that was full goes on recording when there is room.
/// It has no clock: `now_ns` is any time that does not run backwards, such as monotonic_ns(). Used by one thread.
class McapWriter {
 public:
  static constexpr std::uint64_t kNever = std::numeric_limits<std::uint64_t>::max();

  /// Starts the file; an Error leaves nothing behind but an empty file.
  static Result<McapWriter> open(std::unique_ptr<ByteSink> sink, const memory::ChannelInfo& channel,
                                 const McapOptions& options);

  /// Adds a message; writes the chunk if that fills it or if it is old.
  /// An Error tells how many messages are lost, this one among them.
  Result<void> write(const OutMessage& message, std::uint64_t now_ns);

  /// When flush() is wanted at the latest; kNever while nothing is collected.
  std::uint64_t flush_due_ns() const { return flush_due_ns_; }

  /// Writes what is collected.
  Result<void> flush();

  /// Writes what is collected, then the summary. May be tried again after an Error; does nothing when it succeeded.
  Result<void> close();

  std::uint64_t messages() const { return statistics_.messages; }  // in the file
  std::uint64_t lost() const { return lost_; }                     // messages that could not be written
  std::uint64_t size_bytes() const { return good_end_; }           // of the file

 private:
  McapWriter(std::unique_ptr<ByteSink> sink, const McapOptions& options);

  Result<void> write_head(const memory::ChannelInfo& channel, const McapOptions& options);
  Result<void> write_chunk(std::string_view last_bytes);
  Result<mcap::ChunkHead> pack(std::span<const std::string_view> records);
  void count_chunk(const mcap::ChunkHead& head, std::uint64_t record_bytes, std::uint64_t index_bytes);
  void forget_chunk();
  Result<void> append(std::span<const std::string_view> pieces, std::uint32_t crc_after);

  std::unique_ptr<ByteSink> sink_;
  std::uint16_t channel_id_;
  std::size_t chunk_bytes_;
  std::uint64_t chunk_time_ns_;
  Compressor compressor_;

  std::uint64_t good_end_ = 0;  // so many bytes of the file are in good order
  std::uint32_t crc_ = 0;       // of these bytes
  bool torn_ = false;           // there may be bytes behind them, of a write that failed
  bool closed_ = false;

  std::string records_;  // of the chunk that is being collected
  std::string packed_;   // the same, compressed
  mcap::MessageIndex index_;
  std::uint64_t chunk_start_ns_ = 0, chunk_end_ns_ = 0;
  std::uint64_t flush_due_ns_ = kNever;

  mcap::SummaryGroups summary_;
  mcap::Statistics statistics_;
  std::uint64_t lost_ = 0;
};

}  // namespace robot::logging
