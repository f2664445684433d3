// An open MCAP file with its index, which all readers of the file share.
#pragma once

#include <atomic>
#include <filesystem>
#include <memory>
#include <utility>

#include "robot/core/byte_source.h"
#include "robot/core/result.h"
#include "robot/logging/mcap/index.h"

namespace robot::logging {

/// A file and its index, which is read once. Any thread.
class McapFile {
 public:
  /// Returns an Error if the file cannot be read or is not an MCAP file.
  static Result<std::shared_ptr<const McapFile>> open(const std::filesystem::path& path) {
    auto source = FileSource::open(path);
    if (!source) return source.failure();
    return open(std::move(*source));
  }
  static Result<std::shared_ptr<const McapFile>> open(std::shared_ptr<const ByteSource> source) {
    auto index = read_index(*source);
    if (!index) return index.failure();
    return std::shared_ptr<const McapFile>(std::make_shared<McapFile>(std::move(source), std::move(*index)));
  }

  McapFile(std::shared_ptr<const ByteSource> source, McapIndex index)
      : source_(std::move(source)), index_(std::move(index)) {}

  const ByteSource& source() const { return *source_; }
  const McapIndex& index() const { return index_; }

  /// Ends all readers of the file, also those that are reading now: they find no further message.
  void end_reading() const { ended_.store(true, std::memory_order_relaxed); }
  bool ended() const { return ended_.load(std::memory_order_relaxed); }

 private:
  const std::shared_ptr<const ByteSource> source_;
  const McapIndex index_;
  mutable std::atomic<bool> ended_ = false;
};

}  // namespace robot::logging
