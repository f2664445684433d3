#include "robot/logging/mcap/compression.h"

#include <lz4frame.h>
#include <zstd.h>

#include <algorithm>

namespace robot::logging {
namespace {

constexpr int kZstdLevel = 1;
constexpr std::size_t kFirstGrowth = 512 * 1024;  // [bytes] of a decompressed run: our chunks fit at once
constexpr std::size_t kUsualRatio = 8;            // of the sizes; for it no byte is moved while the output grows
constexpr int kZstdWindowLog = 27;                // of the highest level; zstd fills no more of it than `size`

struct FreeLz4 {
  void operator()(LZ4F_cctx* context) const { LZ4F_freeCompressionContext(context); }
  void operator()(LZ4F_dctx* context) const { LZ4F_freeDecompressionContext(context); }
};
struct FreeZstd {
  void operator()(ZSTD_CCtx* context) const { ZSTD_freeCCtx(context); }
  void operator()(ZSTD_DCtx* context) const { ZSTD_freeDCtx(context); }
};

std::size_t total(std::span<const std::string_view> pieces) {
  std::size_t size = 0;
  for (const std::string_view piece : pieces) size += piece.size();
  return size;
}

LZ4F_preferences_t lz4_preferences(std::size_t size) {
  LZ4F_preferences_t preferences{};
  preferences.frameInfo.blockSizeID = LZ4F_max256KB;
  preferences.frameInfo.contentSize = size;
  preferences.autoFlush = 1;  // compress directly from the pieces, without a copy between
  return preferences;
}

Result<void> compress_lz4(LZ4F_cctx* context, std::span<const std::string_view> pieces, std::string& into) {
  const LZ4F_preferences_t preferences = lz4_preferences(total(pieces));
  std::size_t bound = LZ4F_HEADER_SIZE_MAX;
  for (const std::string_view piece : pieces) bound += LZ4F_compressBound(piece.size(), &preferences);
  into.resize(bound);

  std::size_t size = 0;
  std::size_t step = LZ4F_compressBegin(context, into.data(), into.size(), &preferences);
  for (const std::string_view piece : pieces) {
    if (LZ4F_isError(step)) break;
    size += step;
    step = LZ4F_compressUpdate(context, into.data() + size, into.size() - size, piece.data(), piece.size(), nullptr);
  }
  if (!LZ4F_isError(step)) {
    size += step;
    step = LZ4F_compressEnd(context, into.data() + size, into.size() - size, nullptr);
  }
  if (LZ4F_isError(step)) return Error{std::string("cannot compress with lz4: ") + LZ4F_getErrorName(step)};
  into.resize(size + step);
  return {};
}

Result<void> compress_zstd(ZSTD_CCtx* context, std::span<const std::string_view> pieces, std::string& into) {
  ZSTD_CCtx_reset(context, ZSTD_reset_session_only);
  ZSTD_CCtx_setParameter(context, ZSTD_c_compressionLevel, kZstdLevel);
  ZSTD_CCtx_setPledgedSrcSize(context, total(pieces));
  into.resize(ZSTD_compressBound(total(pieces)) + 64);

  ZSTD_outBuffer out{into.data(), into.size(), 0};
  std::size_t left = 0;
  for (const std::string_view piece : pieces) {
    ZSTD_inBuffer in{piece.data(), piece.size(), 0};
    while (in.pos < in.size && !ZSTD_isError(left)) left = ZSTD_compressStream2(context, &out, &in, ZSTD_e_continue);
  }
  ZSTD_inBuffer none{nullptr, 0, 0};
  if (!ZSTD_isError(left)) left = ZSTD_compressStream2(context, &out, &none, ZSTD_e_end);
  if (ZSTD_isError(left)) return Error{std::string("cannot compress with zstd: ") + ZSTD_getErrorName(left)};
  if (left > 0) return Error{"cannot compress with zstd: its bound of the size was too small"};
  into.resize(out.pos);
  return {};
}

/// Calls `step(in, out)` until all frames have ended, and requires exactly `size` bytes of output. `step` reads from
/// `in`, writes to `out`, shortens both by the bytes it used, and returns whether a frame has ended.
template <class Step>
Result<std::string> grow_to(std::size_t size, std::string_view in, const char* what, Step&& step) {
  std::string out;
  out.reserve(std::min(size, kUsualRatio * in.size()));
  std::size_t filled = 0;
  bool in_frame = false;
  while (!in.empty() || in_frame) {
    if (filled == out.size() && filled < size) out.resize(std::min(size, std::max(kFirstGrowth, 2 * out.size())));
    std::span<char> free(out.data() + filled, out.size() - filled);
    const std::size_t bytes_before = in.size(), free_before = free.size();
    const Result<bool> ended = step(in, free);
    if (!ended) return ended.failure(what);
    filled += free_before - free.size();
    in_frame = !*ended;
    const bool stuck = in.size() == bytes_before && free.size() == free_before;
    if (stuck && filled == size)
      return Error{std::string(what) + ": expected " + std::to_string(size) + " bytes, got more"};
    if (stuck) return Error{std::string(what) + ": the compressed bytes end too early"};
  }
  if (filled != size)
    return Error{std::string(what) + ": expected " + std::to_string(size) + " bytes, got " + std::to_string(filled)};
  return out;
}

Result<std::string> decompress_lz4(std::string_view bytes, std::size_t size) {
  LZ4F_dctx* raw = nullptr;
  if (LZ4F_isError(LZ4F_createDecompressionContext(&raw, LZ4F_VERSION))) return Error{"lz4: out of memory"};
  const std::unique_ptr<LZ4F_dctx, FreeLz4> context(raw);
  return grow_to(size, bytes, "lz4", [&](std::string_view& in, std::span<char>& out) -> Result<bool> {
    std::size_t read = in.size(), written = out.size();
    const std::size_t left = LZ4F_decompress(context.get(), out.data(), &written, in.data(), &read, nullptr);
    if (LZ4F_isError(left)) return Error{LZ4F_getErrorName(left)};
    in.remove_prefix(read);
    out = out.subspan(written);
    return left == 0;
  });
}

Result<std::string> decompress_zstd(std::string_view bytes, std::size_t size) {
  const std::unique_ptr<ZSTD_DCtx, FreeZstd> context(ZSTD_createDCtx());
  if (!context) return Error{"zstd: out of memory"};
  ZSTD_DCtx_setParameter(context.get(), ZSTD_d_windowLogMax, kZstdWindowLog);
  return grow_to(size, bytes, "zstd", [&](std::string_view& in, std::span<char>& out) -> Result<bool> {
    ZSTD_inBuffer from{in.data(), in.size(), 0};
    ZSTD_outBuffer to{out.data(), out.size(), 0};
    const std::size_t left = ZSTD_decompressStream(context.get(), &to, &from);
    if (ZSTD_isError(left)) return Error{ZSTD_getErrorName(left)};
    in.remove_prefix(from.pos);
    out = out.subspan(to.pos);
    return left == 0;
  });
}

}  // namespace

struct Compressor::Contexts {
  std::unique_ptr<LZ4F_cctx, FreeLz4> lz4;
  std::unique_ptr<ZSTD_CCtx, FreeZstd> zstd;
};

Compressor::Compressor(Compression compression) : compression_(compression), contexts_(std::make_unique<Contexts>()) {
  LZ4F_cctx* lz4 = nullptr;
  if (compression == Compression::lz4 && !LZ4F_isError(LZ4F_createCompressionContext(&lz4, LZ4F_VERSION)))
    contexts_->lz4.reset(lz4);
  if (compression == Compression::zstd) contexts_->zstd.reset(ZSTD_createCCtx());
}

Compressor::Compressor(Compressor&&) noexcept = default;
Compressor& Compressor::operator=(Compressor&&) noexcept = default;
Compressor::~Compressor() = default;

Result<void> Compressor::compress(std::span<const std::string_view> pieces, std::string& into) {
  switch (compression_) {
    case Compression::none:
      into.clear();
      for (const std::string_view piece : pieces) into.append(piece);
      return {};
    case Compression::lz4:
      if (!contexts_->lz4) return Error{"cannot compress with lz4: out of memory"};
      return compress_lz4(contexts_->lz4.get(), pieces, into);
    case Compression::zstd:
      if (!contexts_->zstd) return Error{"cannot compress with zstd: out of memory"};
      return compress_zstd(contexts_->zstd.get(), pieces, into);
  }
  return Error{"cannot compress: unknown compression"};
}

std::string_view name(Compression compression) {
  switch (compression) {
    case Compression::none: return "";
    case Compression::lz4: return "lz4";
    case Compression::zstd: return "zstd";
  }
  return "?";
}

Result<Compression> compression_named(std::string_view name) {
  if (name.empty()) return Compression::none;
  if (name == "lz4") return Compression::lz4;
  if (name == "zstd") return Compression::zstd;
  return Error{"compression: expected \"\", \"lz4\" or \"zstd\", got \"" + std::string(name.substr(0, 40)) + "\""};
}

Result<std::string> decompress(Compression compression, std::string_view bytes, std::size_t size) {
  switch (compression) {
    case Compression::none:
      if (bytes.size() == size) return std::string(bytes);
      return Error{"expected " + std::to_string(size) + " bytes, got " + std::to_string(bytes.size())};
    case Compression::lz4: return decompress_lz4(bytes, size);
    case Compression::zstd: return decompress_zstd(bytes, size);
  }
  return Error{"cannot decompress: unknown compression"};
}

}  // namespace robot::logging
