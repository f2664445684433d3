// A generator of MCAP files as other writers may make them, with features that our own writer never uses.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

namespace tests {

/// A message as the generator has written it.
struct GeneratedMessage {
  std::uint16_t channel = 0;
  std::uint32_t sequence = 0;
  std::uint64_t log_ns = 0, publish_ns = 0;
  std::string data;

  bool operator==(const GeneratedMessage&) const = default;
};

/// A file, and what a reader must find in it.
struct GeneratedMcap {
  std::string bytes;
  std::vector<GeneratedMessage> messages;  // all that are readable, by log time; those of one time in the file's order
  std::uint64_t unreadable = 0;            // messages without a readable channel, or in a chunk that must be refused
  bool is_valid = true;                    // without damaged records, so that every reader must read it
  std::string features;                    // the choices of the seed, for people
};

/// Makes a file from a seed. The same seed gives the same bytes. A seed chooses among:
/// - chunks, none, or both; chunks that overlap or are out of order; the contents of the summary;
/// - compression, level, frames and skippable frames of each chunk; checksums;
/// - channels described at the start or in the chunks; several channels of a topic; 1000 topics;
/// - times at 0, in 1970 and at 2^63; one time for all; attachments, metadata and unknown records;
/// - damaged metadata, schemas and channels whose framing is intact; a chunk that expands too much.
GeneratedMcap generate_mcap(std::uint32_t seed);

}  // namespace tests
