// One message of a stream, without the type of its data.
#pragma once

#include <cstdint>
#include <string>

namespace robot::logging {

/// One message of a file or a stream.
struct Record {
  std::uint64_t sequence = 0;    // given by its writer; a gap means that messages were dropped
  std::uint64_t capture_ns = 0;  // [ns since the epoch] when the data were sensed
  std::uint64_t publish_ns = 0;  // [ns since the epoch] when it entered the memory that wrote it
  std::string bytes;

  bool operator==(const Record&) const = default;
};

}  // namespace robot::logging
