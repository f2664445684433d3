// A small language for MCAP files in tests: messages are words, and files can be damaged in known places.
#pragma once

#include <cstdint>
#include <limits>
#include <memory>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "robot/core/byte_sink.h"
#include "robot/core/byte_source.h"
#include "robot/logging/mcap/writer.h"

namespace tests {

namespace logging = robot::logging;

/// A file in memory on a disk of limited size.
struct Disk {
  std::string bytes;
  std::uint64_t room = std::numeric_limits<std::uint64_t>::max();  // [bytes] size of the disk
  bool can_truncate = true;
};

/// Writes to a Disk as much as fits.
class DiskSink final : public robot::ByteSink {
 public:
  explicit DiskSink(Disk& disk) : disk_(disk) {}
  robot::Result<void> append(std::span<const std::string_view> pieces) override;
  robot::Result<void> truncate(std::uint64_t size) override;

 private:
  Disk& disk_;
};

/// The channel of the words.
robot::memory::ChannelInfo word_channel(const std::string& topic = "/14/2/word");

/// A writer to `disk` of that channel; the test ends if the head cannot be written.
logging::McapWriter writer_to(Disk& disk, const logging::McapOptions& options = {},
                              const std::string& topic = "/14/2/word");

/// A message with `word` in it; captured at `capture_ns`, published one later, its number is its capture time.
logging::OutMessage word(std::string_view word, std::uint64_t capture_ns);

/// A log of words. "one two | three" are three messages in two chunks, captured at 10, 20 and 30 ns.
class McapText {
 public:
  explicit McapText(std::string_view text, const logging::McapOptions& options = {}, bool finished = true);

  /// Adds `delta` to the byte at `offset`.
  void increment_byte(std::uint64_t offset, int delta = 1);

  /// Cuts the file to `size` bytes.
  void truncate(std::uint64_t size) { bytes.resize(size); }

  /// Gives every chunk that is not compressed the checksum that its bytes have now.
  void fix_chunk_crcs();

  /// Offsets of the chunks, in the order of writing.
  const std::vector<std::uint64_t>& chunks() const { return chunks_; }

  std::shared_ptr<const robot::ByteSource> source() const;

  std::string bytes;

 private:
  std::vector<std::uint64_t> chunks_;
};

/// The words of a file as McapReader delivers them, with a "!" for each reported damage: "one ! three".
std::string words_of(std::shared_ptr<const robot::ByteSource> source, std::vector<std::string>* damages = nullptr);

/// All bytes of a source.
std::string all_bytes(const robot::ByteSource& source);

}  // namespace tests
