// The walk over the records of an MCAP file that its index is made of.
#pragma once

#include "robot/core/byte_source.h"
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

}  // namespace robot::logging
