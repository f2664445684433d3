// Reads the messages of an MCAP file one after the other, around whatever is damaged.
#pragma once

#include <cstdint>
#include <memory>
#include <optional>
#include <set>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "robot/core/byte_source.h"
#include "robot/core/result.h"
#include "robot/logging/mcap/index.h"
#include "robot/logging/mcap/record.h"
#include "robot/logging/mcap/summary.h"

namespace robot::logging {

struct McapMessage {
  std::uint16_t channel_id = 0;
  Record record;
};

/// The messages of an MCAP file with any channels, in chunks or not, as they stand in the file.
/// Holds one chunk at a time, so the file may be of any size. Used by one thread.
///
/// Every message before a damage is delivered. The damage is told once, by an Error with its place in the file;
/// the next call goes on behind it: a chunk with a wrong checksum is left out, and if even the sizes of the records
/// make no sense, reading goes on at the next chunk that the summary knows. What only the checksum over all data shows
/// is told at the end.
class McapReader {
 public:
  explicit McapReader(std::shared_ptr<const ByteSource> source) : source_(std::move(source)) {}

  /// The next message; nothing at the end of the file, and ever after.
  Result<std::optional<McapMessage>> next();

  /// From now on the messages captured at `capture_ns` or later, in the order of the file, from the first chunk on
  /// that holds one. May go back. An Error if the file is not an MCAP file.
  Result<void> seek(std::uint64_t capture_ns);

  /// When the chunks begin that begin at `capture_ns` or before, the earliest first [ns since the epoch]; 0 stands for
  /// messages outside chunks.
  Result<std::vector<std::uint64_t>> chunk_starts_until(std::uint64_t capture_ns);

  /// What was described so far. A message's channel is always among them.
  const SchemasById& schemas() const { return schemas_; }
  const ChannelsById& channels() const { return channels_; }

 private:
  using Next = Result<std::optional<McapMessage>>;

  Next next_in_chunk();
  Next next_in_file();
  Next take(mcap::Op op, std::uint64_t content_bytes);
  Next take_from(const mcap::RecordView& record);
  Next open_chunk(const mcap::RecordView& record);
  Next end_of_data(const mcap::RecordView& record);
  Next lost_track(const std::string& sentence);
  Next unknown_channel(std::uint16_t id);
  const std::optional<mcap::Summary>& summary();
  Error damaged(const std::string& sentence);

  Result<void> need_index();
  Result<bool> can_skip(mcap::Op op, std::uint64_t content_bytes) const;
  Result<void> skip(std::uint64_t bytes);

  std::shared_ptr<const ByteSource> source_;
  std::uint64_t position_ = 0;     // of the next record in the file
  std::uint64_t last_offset_ = 0;  // of the record before it
  bool ended_ = false;
  std::uint64_t from_ns_ = 0;

  std::string content_;             // the record that was read last
  std::string unpacked_;            // the chunk, if it is not in content_
  std::string_view chunk_;          // its records
  std::size_t chunk_at_ = 0;        // of the next record in it
  std::uint64_t chunk_offset_ = 0;  // of the chunk in the file

  bool whole_ = true;      // nothing was left out so far: the checksum over all data is worth comparing
  std::uint32_t crc_ = 0;  // of the file up to position_, while whole_

  std::optional<mcap::Summary> summary_;  // asked for where the data do not tell enough
  bool summary_read_ = false;
  std::optional<McapIndex> index_;  // asked for by seek
  SchemasById schemas_;
  ChannelsById channels_;
  std::set<std::uint16_t> unknown_channels_;  // told of already
};

}  // namespace robot::logging
