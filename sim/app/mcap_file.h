// Many channels into one MCAP file, each in chunks of its own, so that a reader of one does not unpack the others.
#pragma once

#include <cstdint>
#include <filesystem>
#include <map>
#include <memory>
#include <string>
#include <string_view>
#include <vector>

#include "robot/core/byte_sink.h"
#include "robot/core/result.h"
#include "robot/logging/mcap/compression.h"
#include "robot/logging/mcap/format.h"
#include "robot/logging/mcap/summary.h"
#include "robot/logging/mcap/writer.h"
#include "robot/memory/channel.h"

namespace sim::app {

/// The same messages in the same order give the same bytes. A chunk is written when it has 256 kB or spans 10 s.
/// Used by one thread.
class McapFile {
 public:
  /// Makes the file and writes what it says of itself; an Error if there is one already.
  static robot::Result<McapFile> create(const std::filesystem::path& path,
                                        const std::vector<robot::memory::ChannelInfo>& channels,
                                        const robot::logging::MetadataByName& metadata);

  /// Adds a message to the channel with that index in the list of channels; times of a channel must not go back.
  robot::Result<void> write(std::size_t channel, std::uint64_t capture_ns, std::string_view bytes);

  /// Writes what is collected, and the summary.
  robot::Result<void> close();

  std::uint64_t messages() const { return statistics_.messages; }
  std::uint64_t size_bytes() const { return size_; }

 private:
  /// The chunk of a channel that is being collected.
  struct Chunk {
    std::string records;
    robot::logging::mcap::MessageIndex index;
    std::uint32_t messages = 0;  // of the channel so far
  };

  explicit McapFile(std::unique_ptr<robot::ByteSink> sink);
  robot::Result<void> write_head(const std::vector<robot::memory::ChannelInfo>& channels,
                                 const robot::logging::MetadataByName& metadata);
  robot::Result<void> flush(Chunk& chunk);
  robot::Result<void> append(std::string_view bytes);

  std::unique_ptr<robot::ByteSink> sink_;
  robot::logging::Compressor compressor_{robot::logging::Compression::zstd};
  std::vector<Chunk> chunks_;  // by channel; the id in the file is one more
  robot::logging::mcap::SummaryGroups summary_;
  robot::logging::mcap::Statistics statistics_;
  std::uint64_t size_ = 0;
  std::uint32_t crc_ = 0;
};

}  // namespace sim::app
