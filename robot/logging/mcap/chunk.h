// The contents of a chunk of an MCAP file.
#pragma once

#include <cstdint>
#include <map>
#include <string>
#include <string_view>
#include <vector>

#include "robot/core/result.h"
#include "robot/logging/mcap/format.h"

namespace robot::logging::mcap {

/// Unpacks the records of the Chunk record with this `content` and verifies their checksum. The returned bytes are in
/// `content` itself or in `room`. `offset` is the chunk's offset in the file, for the sentence of an Error.
Result<std::string_view> unpack_chunk(std::string_view content, std::uint64_t offset, std::string& room);

/// The indexes and descriptions from one chunk.
struct ChunkContents {
  std::map<std::uint16_t, MessageIndex> indexes;  // by channel; the same records should follow the chunk
  std::vector<Schema> schemas;
  std::vector<Channel> channels;
};

/// Reads through the unpacked `records` of the chunk at `offset`.
Result<ChunkContents> survey_chunk(std::string_view records, std::uint64_t offset);

}  // namespace robot::logging::mcap
