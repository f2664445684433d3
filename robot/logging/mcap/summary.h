// The end of an MCAP file after the data: DataEnd, summary, Footer. With it a reader finds any chunk at once.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "robot/core/byte_source.h"
#include "robot/core/result.h"
#include "robot/logging/mcap/format.h"

namespace robot::logging::mcap {

/// The summary while a file is written: encoded records of each kind, in the order of the file.
struct SummaryGroups {
  std::string schemas, channels, statistics, metadata_indexes, chunk_indexes;
};

/// Encodes everything after the data of a file, up to the last magic. `offset` is its offset in the file.
/// `data_crc` is the CRC-32 of the file up to this offset, or 0 if it is unknown.
std::string encode_end(const SummaryGroups& groups, std::uint64_t offset, std::uint32_t data_crc);

/// The summary of a file that was read. It has not been compared with the data.
struct Summary {
  std::vector<Schema> schemas;
  std::vector<Channel> channels;
  std::optional<Statistics> statistics;
  std::vector<MetadataIndex> metadata_indexes;
  std::vector<ChunkIndex> chunk_indexes;  // by offset; all within the data and without overlap
  std::uint64_t data_end = 0;             // offset of the DataEnd record
};

/// Reads the summary of a file. Returns nothing if the file has a valid end without a summary.
/// Returns an Error if the file has no valid end, or if the summary's checksum or structure is wrong.
Result<std::optional<Summary>> read_summary(const ByteSource& source);

}  // namespace robot::logging::mcap
