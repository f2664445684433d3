// The status of one stream.
#pragma once

#include <cstdint>
#include <string>

namespace robot::logging {

struct StreamStatus {
  std::string topic;
  std::uint64_t messages = 0;      // on the device, or read from it
  std::uint64_t dropped = 0;       // lost: the queue was full, the device refused them, or the stream reports a loss
  std::uint64_t waiting = 0;       // messages in the queue and in the device's buffer now
  std::uint64_t queued_bytes = 0;  // in the queue now
  std::uint64_t first = 0;         // sequence numbers of the first and the newest version that a logger got; 0: none
  std::uint64_t newest = 0;
  bool failing = false;            // the device has taken nothing since a failure; `problem` gives the reason
  bool ended = false;              // no more messages will follow
  std::string problem;             // one sentence, or empty without a problem
  std::uint64_t failed_ns = 0;     // [ns, monotonic] of the last failure; 0: none
  std::uint64_t delivered_ns = 0;  // [ns, monotonic] when the device had last taken everything; 0: never
};

}  // namespace robot::logging
