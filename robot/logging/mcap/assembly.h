// A session's download: many stream files seen as one MCAP file that is nowhere on disk.
#pragma once

#include <cstdint>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "robot/core/byte_source.h"
#include "robot/core/result.h"
#include "robot/logging/mcap/format.h"

namespace robot::logging {

/// Which chunks are taken; all times are capture times [ns since the epoch].
struct AssemblyOptions {
  std::optional<std::uint64_t> from_ns, to_ns;  // chunks that overlap this range, both ends included
  /// Chunks that end at this time or earlier, and are in the file with their index: fixes what the download of a live
  /// session is. Choose it so far back that every stream has written its chunks up to then.
  std::optional<std::uint64_t> until_ns;
  /// The one whose messages are wanted: chunks without any are left out. Other channels' messages in chunks that hold
  /// some of its own stay.
  std::optional<std::string> topic;
};

/// One MCAP file made of several: a head of its own, the chunks of all files byte for byte in the order of their
/// start times, and a summary of its own. Nothing is unpacked or copied; bytes are fetched when they are read.
/// Holds the files open. Any thread.
class Assembly final : public ByteSource {
 public:
  const std::string& name() const override { return name_; }
  std::uint64_t size() const override { return size_; }
  Result<void> read(std::uint64_t offset, std::span<char> into) const override;

  /// Names the content, as HTTP's strong ETag without the quotes: the same chunks of the same files give the same one.
  const std::string& etag() const { return etag_; }

  /// What is in it.
  const mcap::Statistics& statistics() const { return statistics_; }

  /// What was wrong with the files, and that the rest of them is in it; empty if nothing.
  const std::string& damage() const { return damage_; }

 private:
  friend class AssemblyBuilder;

  /// A run of bytes that is taken from one place; it reaches up to the next one.
  struct Extent {
    std::uint64_t begin;   // in the assembly
    std::uint64_t offset;  // in the file, or in made_
    std::uint32_t file;    // kMade: not from a file
  };
  static constexpr std::uint32_t kMade = 0xffff'ffff;

  std::string name_ = "assembly";
  std::vector<std::shared_ptr<const ByteSource>> files_;
  std::string made_;  // head, tail, and message indexes of chunks that lack them
  std::vector<Extent> extents_;
  std::uint64_t size_ = 0;
  std::string etag_, damage_;
  mcap::Statistics statistics_;
};

/// Makes one MCAP file of the stream files of a session, or of one of them. Files whose writers died are taken as far
/// as they are whole. Channels keep their ids; an Error if two files use the same one, if a file is no MCAP file, or if
/// one holds messages outside chunks.
/// Metadata of the same name are taken from the first file that has them; attachments are left out.
Result<Assembly> assemble(std::vector<std::shared_ptr<const ByteSource>> files, const AssemblyOptions& options = {});

}  // namespace robot::logging
