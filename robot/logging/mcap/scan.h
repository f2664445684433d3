// Going through an MCAP file whose summary is missing or wrong.
#pragma once

#include "robot/core/byte_source.h"
#include "robot/logging/mcap/chunk.h"
#include "robot/logging/mcap/index.h"

namespace robot::logging {

/// What the file holds up to the first record that is not whole; that one is named in `damage`.
/// Reads heads only, and unpacks a chunk where these do not tell enough: the last one of an interrupted file,
/// one without message indexes, one with channels that were not described before. `header` and `size_bytes` stay empty.
McapIndex scan(const ByteSource& source);

/// Reads and unpacks one chunk.
Result<mcap::ChunkContents> read_chunk(const ByteSource& source, const mcap::ChunkIndex& chunk);

}  // namespace robot::logging
