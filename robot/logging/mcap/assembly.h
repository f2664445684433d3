// A session's download: a view of many stream files as one MCAP file that does not exist on the disk.
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

/// The choice of chunks. All times are capture times [ns since the epoch].
struct AssemblyOptions {
  std::optional<std::uint64_t> from_ns, to_ns;  // chunks that overlap this range, both ends included
  /// Limit to chunks that end at this time or earlier and have their index in the file. It fixes the content of a live
  /// session's download. It must be early enough that every stream has written its chunks up to this time.
  std::optional<std::uint64_t> until_ns;
  /// The topic of interest: leaves out the chunks without messages of it. The remaining chunks keep their messages of
  /// other channels.
  std::optional<std::string> topic;
};

/// One MCAP file made of several. It has a head and a summary of its own. Between them are the chunks of all files,
/// byte for byte, in the order of their start times. It unpacks and copies nothing; read() fetches the bytes from the
/// files. It keeps the files open. Any thread.
class Assembly final : public ByteSource {
 public:
  const std::string& name() const override { return name_; }
  std::uint64_t size() const override { return size_; }
  Result<void> read(std::uint64_t offset, std::span<char> into) const override;

  /// Returns the strong ETag of HTTP, without quotes. The same chunks of the same files give the same tag.
  const std::string& etag() const { return etag_; }

  /// Returns the counts and times of the content.
  const mcap::Statistics& statistics() const { return statistics_; }

  /// Returns a sentence about damaged files, whose undamaged rest is part of the assembly; empty without damage.
  const std::string& damage() const { return damage_; }

 private:
  friend class AssemblyBuilder;

  /// A run of bytes from one place. It ends where the next extent begins.
  struct Extent {
    std::uint64_t begin;   // in the assembly
    std::uint64_t offset;  // in the file, or in made_
    std::uint32_t file;    // index in files_; kMade: from made_
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

/// Combines the stream files of a session, or some of them, into one MCAP file. From a file whose writer died it takes
/// the complete chunks. Channels keep their ids. Metadata of the same name are from the first file that has them.
/// Attachments are left out.
///
/// Returns an Error if two files use the same channel id, if one is not an MCAP file, or if one holds messages outside
/// chunks.
Result<Assembly> assemble(std::vector<std::shared_ptr<const ByteSource>> files, const AssemblyOptions& options = {});

}  // namespace robot::logging
