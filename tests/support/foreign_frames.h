// Compressed bytes as other writers may make them: several frames, skippable ones, any level.
#pragma once

#include <random>
#include <string>
#include <string_view>

namespace tests {

/// The choices for one chunk.
struct FrameOptions {
  std::string compression;  // "lz4" or "zstd"
  int level = 1;
  int frames = 1;            // the bytes are split at random places
  bool skippable = false;    // with skippable frames before, between and after them
  bool content_size = true;  // in the head of each frame
  bool checksum = false;     // at the end of each frame
  int window_log = 0;        // of zstd; 0: as the size of the bytes allows
};

/// Compresses `bytes`. Aborts if the library fails.
std::string foreign_frames(std::string_view bytes, const FrameOptions& options, std::mt19937& random);

}  // namespace tests
