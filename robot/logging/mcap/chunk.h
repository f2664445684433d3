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

/// The indexes and descriptions from one chunk, as far as its records are readable.
struct ChunkContents {
  std::map<std::uint16_t, MessageIndex> indexes;  // by channel; the same records should follow the chunk
  std::vector<Schema> schemas;
  std::vector<Channel> channels;
  std::string damage;  // a sentence about the first damage; empty without damage
};

/// Reads through the records of a chunk, or of any part of a file. Leaves out damaged records, and everything after a
/// record with a wrong length. `where` names the place in the sentence about a damage: "Chunk at byte 7".
ChunkContents survey_records(std::string_view records, const std::string& where);

}  // namespace robot::logging::mcap
