// How the chunks of a recording are made small.
#pragma once

#include <cstddef>
#include <memory>
#include <span>
#include <string>
#include <string_view>

#include "robot/core/result.h"

namespace robot::logging {

enum class Compression {
  none,  // for what is compressed already
  lz4,   // frame format; cheap enough for the robot
  zstd,  // level 1; half of lz4's size at twice its time
};

/// As an MCAP file says it: "", "lz4" or "zstd".
std::string_view name(Compression compression);

/// The compression of that name; an Error for all but those three.
Result<Compression> compression_named(std::string_view name);

/// Compresses run after run, with the same working memory. Used by one thread.
class Compressor {
 public:
  explicit Compressor(Compression compression);
  Compressor(Compressor&&) noexcept;
  Compressor& operator=(Compressor&&) noexcept;
  ~Compressor();

  Compression compression() const { return compression_; }

  /// `pieces`, one behind the other, compressed; the same bytes if that is none. Replaces `into`, keeps its capacity.
  Result<void> compress(std::span<const std::string_view> pieces, std::string& into);

 private:
  struct Contexts;

  Compression compression_;
  std::unique_ptr<Contexts> contexts_;
};

/// The `size` bytes that were compressed to `bytes`; an Error if they are fewer or more.
/// Never holds more than `size` bytes, and grows only as they come: a lie about the size costs no memory.
Result<std::string> decompress(Compression compression, std::string_view bytes, std::size_t size);

}  // namespace robot::logging
