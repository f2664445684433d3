// What stands behind the data of an MCAP file: DataEnd, summary, Footer. It lets a reader find any chunk at once.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "robot/core/byte_source.h"
#include "robot/core/result.h"
#include "robot/logging/mcap/format.h"

namespace robot::logging::mcap {

/// The summary while a file is written: encoded records of each kind, in the order in which they will stand.
struct SummaryGroups {
  std::string schemas, channels, statistics, metadata_indexes, chunk_indexes;
};

/// Everything behind the data of a file, up to the last magic. `offset` is where it will stand;
/// `data_crc` is the CRC-32 of the file up to there, 0 if it is not known.
std::string encode_end(const SummaryGroups& groups, std::uint64_t offset, std::uint32_t data_crc);

/// The summary as it is read back. Nothing in it has been compared with the data.
struct Summary {
  std::vector<Schema> schemas;
  std::vector<Channel> channels;
  std::optional<Statistics> statistics;
  std::vector<MetadataIndex> metadata_indexes;
  std::vector<ChunkIndex> chunk_indexes;  // by offset; each within the data, none over another
  std::uint64_t data_end = 0;             // offset of the DataEnd record
};

/// The summary of a file; nothing if the file ends in good order but was written without one.
/// An Error if the file does not end in good order, or if the summary's checksum or structure is wrong.
Result<std::optional<Summary>> read_summary(const ByteSource& source);

}  // namespace robot::logging::mcap
