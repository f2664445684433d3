// A reader of the messages of an MCAP file, one after the other, that skips damaged parts.
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

  bool operator==(const McapMessage&) const = default;
};

/// The messages of an MCAP file with any number of channels, inside and outside chunks, in the order of the file.
/// It holds one chunk at a time, so the file may have any size. Used by one thread.
///
/// The reader delivers every message before a damage. It reports each damage once, by an Error with the place in the
/// file, and the next call continues after it. A chunk with a wrong checksum is left out. If the sizes of records are
/// wrong too, the reader continues at the next chunk of the summary. It reports at the end of the file a damage that
/// only the checksum over all data shows.
class McapReader {
 public:
  explicit McapReader(std::shared_ptr<const ByteSource> source) : source_(std::move(source)) {}

  /// Returns the next message, or nothing from the end of the file on.
  Result<std::optional<McapMessage>> next();

  /// Continues with the messages captured at `capture_ns` or later, in the order of the file, from the first chunk that
  /// holds one. May move backwards. Returns an Error if the file is not an MCAP file.
  Result<void> seek(std::uint64_t capture_ns);

  /// Returns the start times at `capture_ns` or before of all chunks, the earliest first [ns since the epoch]. An entry
  /// 0 means messages outside chunks.
  Result<std::vector<std::uint64_t>> chunk_starts_until(std::uint64_t capture_ns);

  /// The schemas and channels read up to now. They always include the channel of a returned message.
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

  std::string content_;             // of the last record
  std::string unpacked_;            // the chunk, if it is not in content_
  std::string_view chunk_;          // its records
  std::size_t chunk_at_ = 0;        // of the next record in it
  std::uint64_t chunk_offset_ = 0;  // of the chunk in the file

  bool whole_ = true;      // no byte was skipped up to now, so the checksum over all data can be compared
  std::uint32_t crc_ = 0;  // of the file up to position_, while whole_

  std::optional<mcap::Summary> summary_;  // read only if the data are not sufficient
  bool summary_read_ = false;
  std::optional<McapIndex> index_;  // read by the first seek()
  SchemasById schemas_;
  ChannelsById channels_;
  std::set<std::uint16_t> unknown_channels_;  // reported already
};

}  // namespace robot::logging
