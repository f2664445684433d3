// The bytes of one chunk, or of one run of messages outside chunks.
#pragma once

#include <string>

#include "robot/core/byte_source.h"
#include "robot/core/result.h"
#include "robot/logging/mcap/chunk.h"
#include "robot/logging/mcap/index.h"

namespace robot::logging {

/// Returns "Chunk at byte 7" or "records at byte 7", for the sentence of an Error.
std::string place_of(const ChunkInfo& piece);

/// Returns an Error if a reader must not take the piece into memory, because it is larger than kMaxRecordBytes.
Result<void> fits_memory(const ChunkInfo& piece);

/// Reads and unpacks one piece. Returns its records.
Result<std::string> read_records(const ByteSource& source, const ChunkInfo& piece);

/// Reads and unpacks one chunk.
Result<mcap::ChunkContents> read_chunk(const ByteSource& source, const mcap::ChunkIndex& chunk);

}  // namespace robot::logging
