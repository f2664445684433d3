// The compression of a recording's chunks.
#pragma once

#include <cstddef>
#include <memory>
#include <span>
#include <string>
#include <string_view>

#include "robot/core/result.h"

namespace robot::logging {

enum class Compression {
  none,  // for data that are compressed already
  lz4,   // frame format; cheap enough for the robot
  zstd,  // level 1; half the size of lz4 in twice the time
};

/// Returns the compression's name in an MCAP file: "", "lz4" or "zstd".
std::string_view name(Compression compression);

/// Returns the compression of that name, or an Error for any other name than these three.
Result<Compression> compression_named(std::string_view name);

/// A compressor that reuses its working memory for each run of bytes. Used by one thread.
class Compressor {
 public:
  explicit Compressor(Compression compression);
  Compressor(Compressor&&) noexcept;
  Compressor& operator=(Compressor&&) noexcept;
  ~Compressor();

  Compression compression() const { return compression_; }

  /// Compresses the concatenation of `pieces` into `into`; with Compression::none, copies it. Replaces the contents of
  /// `into` and keeps its capacity.
  Result<void> compress(std::span<const std::string_view> pieces, std::string& into);

 private:
  struct Contexts;

  Compression compression_;
  std::unique_ptr<Contexts> contexts_;
};

/// Decompresses `bytes`: frames of any level, one after the other, also skippable ones. Returns an Error if this does
/// not give exactly `size` bytes.
/// The output never holds more than `size` bytes and grows only with the data, so that a false size costs no memory.
Result<std::string> decompress(Compression compression, std::string_view bytes, std::size_t size);

}  // namespace robot::logging
