// A writer of MCAP files with any number of channels. The death of the process costs one second of messages at most. It
// does not call fsync: a loss of power may also cost written chunks that the system has not stored yet.
#pragma once

#include <cstddef>
#include <cstdint>
#include <map>
#include <memory>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "robot/core/byte_sink.h"
#include "robot/core/clock.h"
#include "robot/core/result.h"
#include "robot/logging/mcap/collected_chunk.h"
#include "robot/logging/mcap/compression.h"
#include "robot/logging/mcap/format.h"
#include "robot/logging/mcap/summary.h"
#include "robot/memory/channel.h"

namespace robot::logging {

/// The metadata of a session: records by name, each with its entries.
using MetadataByName = std::map<std::string, std::map<std::string, std::string>>;

struct McapOptions {
  std::uint16_t first_channel_id = 1;  // the others follow; ids are unique within a session
  MetadataByName metadata;
  std::string library = "foresight";  // name and version of the writing program
  Compression compression = Compression::none;
  std::size_t chunk_bytes = 256 * 1024;   // size of a chunk that is written at once
  std::uint64_t chunk_time_ns = kSecond;  // age of a chunk's first message at which the chunk is written
};

/// One message for the writer. `bytes` must be valid only during the call.
struct OutMessage {
  std::uint64_t sequence = 0;  // the file keeps the lower 32 bits
  std::uint64_t capture_ns = 0, publish_ns = 0;
  std::string_view bytes;
};

/// A recording of one or more channels. The writer writes the file's description at once. It collects the messages of
/// each channel into chunks of this channel, so that a reader of one channel does not unpack the others. It appends each
/// chunk with its index in one operation. Without close() the file is readable up to its last chunk, as after the death
/// of the process. The same calls give the same bytes.
///
/// A lack of memory costs the message or the chunk for which there was none; the file stays whole.
///
/// After a failed write the writer truncates the file to its last good end. It counts the messages of that chunk as
/// lost and tries again with the next chunk, so that recording continues when a full disk has space again.
///
/// The writer has no clock: `now_ns` is any time that never decreases, such as monotonic_ns(). Used by one thread.
class McapWriter {
 public:
  static constexpr std::uint64_t kNever = mcap::CollectedChunk::kNever;

  /// Writes the head of the file. Equal schemas of several channels are written once. After an Error the file is empty.
  static Result<McapWriter> open(std::unique_ptr<ByteSink> sink, std::span<const memory::ChannelInfo> channels,
                                 const McapOptions& options);

  /// Adds a message of the channel with that index in the list of open(). Writes the channel's chunk if it is full or
  /// old. An Error contains the number of lost messages, including this one.
  Result<void> write(std::size_t channel, const OutMessage& message, std::uint64_t now_ns);

  /// Returns the latest time for the next flush(), or kNever while no message is collected.
  std::uint64_t flush_due_ns() const;

  /// Writes the collected messages of each channel that is due at `now_ns`; by default, of all channels.
  /// A failure costs only the messages of its chunk. An Error contains the number of lost messages.
  Result<void> flush(std::uint64_t now_ns = kNever);

  /// Writes the collected messages, then the summary. After an Error it may be called again. After a success a further
  /// call has no effect.
  Result<void> close();

  std::uint64_t messages() const { return statistics_.messages; }  // in the file
  std::uint64_t collected() const;                                 // not yet in the file, of all channels
  std::uint64_t lost() const { return lost_; }                     // messages of failed writes
  std::uint64_t size_bytes() const { return good_end_; }           // of the file

 private:
  McapWriter(std::unique_ptr<ByteSink> sink, const McapOptions& options);

  Result<void> write_head(std::span<const memory::ChannelInfo> channels, const McapOptions& options);
  void describe(std::span<const memory::ChannelInfo> channels, std::uint16_t first_id);
  Result<void> write_chunk(std::size_t channel, std::string_view last_bytes);
  Result<void> append_chunk(std::size_t channel, std::string_view last_bytes);
  Result<mcap::ChunkHead> pack(const mcap::CollectedChunk& chunk, std::span<const std::string_view> records);
  void count_chunk(std::size_t channel, const mcap::ChunkHead& head, std::uint64_t record_bytes,
                   std::uint64_t index_bytes);
  Result<void> append(std::span<const std::string_view> pieces, std::uint32_t crc_after);

  std::unique_ptr<ByteSink> sink_;
  std::size_t chunk_bytes_;
  std::uint64_t chunk_time_ns_;
  Compressor compressor_;

  std::uint64_t good_end_ = 0;  // [bytes] end of the last complete write
  std::uint32_t crc_ = 0;       // of the file up to good_end_
  bool torn_ = false;           // the file may have more bytes after good_end_, from a failed write
  bool closed_ = false;

  std::vector<mcap::CollectedChunk> chunks_;  // by channel
  std::string packed_;                        // the records of the last written chunk, compressed

  mcap::SummaryGroups summary_;
  mcap::Statistics statistics_;  // with all channels, also those without messages
  std::uint64_t lost_ = 0;
};

}  // namespace robot::logging
