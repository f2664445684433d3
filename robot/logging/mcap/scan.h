// The scan of an MCAP file whose summary is missing or wrong.
#pragma once

#include "robot/core/byte_source.h"
#include "robot/logging/mcap/chunk.h"
#include "robot/logging/mcap/index.h"

namespace robot::logging {

/// Returns the index of the file up to the first incomplete record, which `damage` names. `header` and `size_bytes`
/// stay empty.
///
/// It reads heads only, and unpacks a chunk if the heads are not sufficient. These are the last chunk of an interrupted
/// file, chunks without message indexes, and chunks with channels that were not described before.
McapIndex scan(const ByteSource& source);

/// Reads and unpacks one chunk.
Result<mcap::ChunkContents> read_chunk(const ByteSource& source, const mcap::ChunkIndex& chunk);

}  // namespace robot::logging
