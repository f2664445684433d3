#include "tests/support/foreign_frames.h"

#include <lz4frame.h>
#include <zstd.h>

#include <algorithm>
#include <cstdlib>
#include <vector>

#include "tests/support/mcap_bytes.h"

namespace tests {
namespace {

void require(bool holds) {
  if (!holds) std::abort();
}

std::string zstd_frame(std::string_view bytes, const FrameOptions& options) {
  ZSTD_CCtx* context = ZSTD_createCCtx();
  require(context != nullptr);
  ZSTD_CCtx_setParameter(context, ZSTD_c_compressionLevel, options.level);
  ZSTD_CCtx_setParameter(context, ZSTD_c_contentSizeFlag, options.content_size);
  ZSTD_CCtx_setParameter(context, ZSTD_c_checksumFlag, options.checksum);
  std::string out(ZSTD_compressBound(bytes.size()) + 64, 0);
  ZSTD_inBuffer in{bytes.data(), bytes.size(), 0};
  ZSTD_outBuffer to{out.data(), out.size(), 0};
  if (options.window_log > 0) {
    // the library does not know the size yet, so it cannot reduce the window
    ZSTD_CCtx_setParameter(context, ZSTD_c_windowLog, options.window_log);
    require(!ZSTD_isError(ZSTD_compressStream2(context, &to, &in, ZSTD_e_continue)));
  }
  require(ZSTD_compressStream2(context, &to, &in, ZSTD_e_end) == 0);
  ZSTD_freeCCtx(context);
  out.resize(to.pos);
  return out;
}

std::string lz4_frame(std::string_view bytes, const FrameOptions& options) {
  LZ4F_preferences_t preferences{};
  preferences.compressionLevel = options.level;
  preferences.frameInfo.contentSize = options.content_size ? bytes.size() : 0;
  preferences.frameInfo.contentChecksumFlag = options.checksum ? LZ4F_contentChecksumEnabled : LZ4F_noContentChecksum;
  preferences.frameInfo.blockMode = options.level % 2 == 0 ? LZ4F_blockLinked : LZ4F_blockIndependent;
  std::string out(LZ4F_compressFrameBound(bytes.size(), &preferences), 0);
  const std::size_t size = LZ4F_compressFrame(out.data(), out.size(), bytes.data(), bytes.size(), &preferences);
  require(!LZ4F_isError(size));
  out.resize(size);
  return out;
}

/// lz4 and zstd have the same skippable frames.
std::string skippable_frame(std::mt19937& random) {
  const std::string content(random() % 50, 's');
  return McapBytes().u32(0x184D2A50 + random() % 16).text(content).bytes();
}

}  // namespace

std::string foreign_frames(std::string_view bytes, const FrameOptions& options, std::mt19937& random) {
  std::vector<std::size_t> cuts{0, bytes.size()};
  for (int i = 1; i < options.frames; ++i) cuts.push_back(random() % (bytes.size() + 1));
  std::ranges::sort(cuts);
  std::string out = options.skippable ? skippable_frame(random) : "";
  for (std::size_t i = 0; i + 1 < cuts.size(); ++i) {
    const std::string_view piece = bytes.substr(cuts[i], cuts[i + 1] - cuts[i]);
    out += options.compression == "zstd" ? zstd_frame(piece, options) : lz4_frame(piece, options);
    if (options.skippable && random() % 2 == 0) out += skippable_frame(random);
  }
  return out;
}

}  // namespace tests
