// The walk over the records of an MCAP file that its index is made of.
#pragma once

#include <string>

#include "robot/core/byte_source.h"
#include "robot/logging/mcap/chunk.h"
#include "robot/logging/mcap/index.h"
#include "robot/logging/mcap/summary.h"

namespace robot::logging {

/// Returns the index of a file. `summary` is its summary, or null if it is missing or wrong. `header` and `size_bytes`
/// stay empty.
///
/// With a summary the walk visits only the records between the chunks that the summary names. Without one it goes over
/// all records up to the first incomplete one, which `damage` names. It reads heads only, and unpacks a chunk if the
/// heads are not sufficient. These are the last chunk of an interrupted file, chunks that no one has counted, and chunks
/// with channels that were not described before.
McapIndex scan(const ByteSource& source, const mcap::Summary* summary);

/// Reads and unpacks one chunk or run. Returns its records.
Result<std::string> read_records(const ByteSource& source, const ChunkInfo& piece);

/// Reads and unpacks one chunk.
Result<mcap::ChunkContents> read_chunk(const ByteSource& source, const mcap::ChunkIndex& chunk);

/// Returns "Chunk at byte 7" or "records at byte 7", for the sentence of an Error.
std::string place_of(const ChunkInfo& piece);

}  // namespace robot::logging
