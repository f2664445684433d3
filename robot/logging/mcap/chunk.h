// What is inside a chunk of an MCAP file.
#pragma once

#include <cstdint>
#include <map>
#include <string>
#include <string_view>
#include <vector>

#include "robot/core/result.h"
#include "robot/logging/mcap/format.h"

namespace robot::logging::mcap {

/// The records of the Chunk record with this `content`, unpacked and compared with their checksum.
/// They lie in `content` itself or in `room`. `offset` is where the chunk stands, for the sentence of an Error.
Result<std::string_view> unpack_chunk(std::string_view content, std::uint64_t offset, std::string& room);

/// What a chunk holds.
struct ChunkContents {
  std::map<std::uint16_t, MessageIndex> indexes;  // by channel: what should stand behind the chunk
  std::vector<Schema> schemas;
  std::vector<Channel> channels;
};

/// Goes through the unpacked `records` of the chunk at `offset`.
Result<ChunkContents> survey_chunk(std::string_view records, std::uint64_t offset);

}  // namespace robot::logging::mcap
