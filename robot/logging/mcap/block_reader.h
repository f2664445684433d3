// Small reads of a source through one block.
#pragma once

#include <algorithm>
#include <cstdint>
#include <string>
#include <string_view>

#include "robot/core/byte_source.h"
#include "robot/core/result.h"

namespace robot::logging {

/// A block of a source, so that a walk over many small records needs few system calls. Used by one thread.
class BlockReader {
 public:
  explicit BlockReader(const ByteSource& source) : source_(source) {}

  /// Returns `length` bytes from `offset` on, valid until the next call. Returns an Error if there are not enough.
  Result<std::string_view> read(std::uint64_t offset, std::uint64_t length) {
    const bool inside =
        offset >= begin_ && offset - begin_ <= block_.size() && length <= block_.size() - (offset - begin_);
    if (!inside) {
      const std::uint64_t left = source_.size() - std::min(offset, source_.size());
      Result<std::string> block = read_bytes(source_, offset, std::max(length, std::min(left, kBlockBytes)));
      if (!block) return block.failure();
      block_ = std::move(*block);
      begin_ = offset;
    }
    return std::string_view(block_).substr(static_cast<std::size_t>(offset - begin_), static_cast<std::size_t>(length));
  }

 private:
  static constexpr std::uint64_t kBlockBytes = 16 * 1024;

  const ByteSource& source_;
  std::string block_;
  std::uint64_t begin_ = 0;  // of block_ in the source
};

}  // namespace robot::logging
