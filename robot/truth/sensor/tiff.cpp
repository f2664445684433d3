#include "robot/truth/sensor/tiff.h"

#include <tiffio.h>

#include <algorithm>
#include <cstdarg>
#include <cstdio>
#include <cstring>
#include <memory>
#include <string>

#include "robot/core/text.h"

namespace robot::truth {
namespace {

/// One reading of a TIFF in memory.
struct TiffReading {
  std::string_view bytes;
  std::size_t at = 0;
  std::string sentence;  // of the first error
};

TiffReading& tiff_reading(thandle_t handle) { return *static_cast<TiffReading*>(handle); }

tmsize_t take_tiff_bytes(thandle_t handle, void* into, tmsize_t size) {
  TiffReading& reading = tiff_reading(handle);
  const std::string_view taken =
      reading.bytes.substr(reading.at, static_cast<std::size_t>(std::max<tmsize_t>(size, 0)));
  std::memcpy(into, taken.data(), taken.size());
  reading.at += taken.size();
  return static_cast<tmsize_t>(taken.size());
}

tmsize_t write_no_tiff(thandle_t, void*, tmsize_t) { return -1; }

toff_t seek_in_tiff(thandle_t handle, toff_t offset, int whence) {
  TiffReading& reading = tiff_reading(handle);
  const toff_t base = whence == SEEK_SET ? 0 : whence == SEEK_CUR ? reading.at : reading.bytes.size();
  // a place behind the end is the end: reading there delivers nothing
  reading.at = static_cast<std::size_t>(std::min<toff_t>(base + offset, reading.bytes.size()));
  return reading.at;
}

int close_no_tiff(thandle_t) { return 0; }

toff_t size_of_tiff(thandle_t handle) { return tiff_reading(handle).bytes.size(); }

[[gnu::format(printf, 4, 0)]] int keep_tiff_error(TIFF*, void* user, const char*, const char* format, va_list values) {
  std::string& sentence = static_cast<TiffReading*>(user)->sentence;
  char text[160];
  std::vsnprintf(text, sizeof text, format, values);
  if (sentence.empty()) sentence = text;
  return 1;
}

int ignore_tiff_warning(TIFF*, void*, const char*, const char*, va_list) { return 1; }

struct CloseTiff {
  void operator()(TIFF* tiff) const { TIFFClose(tiff); }
};

using OpenTiff = std::unique_ptr<TIFF, CloseTiff>;

OpenTiff open_tiff(TiffReading& reading) {
  TIFFOpenOptions* options = TIFFOpenOptionsAlloc();
  TIFFOpenOptionsSetMaxSingleMemAlloc(options, static_cast<tmsize_t>(kMaxImageBytes));
  TIFFOpenOptionsSetErrorHandlerExtR(options, keep_tiff_error, &reading);
  TIFFOpenOptionsSetWarningHandlerExtR(options, ignore_tiff_warning, nullptr);
  // without mapping of the file into memory, which libtiff would do by functions of ours (m)
  OpenTiff tiff(TIFFClientOpenExt("image", "rm", &reading, take_tiff_bytes, write_no_tiff, seek_in_tiff, close_no_tiff,
                                  size_of_tiff, nullptr, nullptr, options));
  TIFFOpenOptionsFree(options);
  return tiff;
}

template <class Number>
Number tiff_field(const OpenTiff& tiff, std::uint32_t tag) {
  Number value = 0;
  TIFFGetFieldDefaulted(tiff.get(), tag, &value);
  return value;
}

Result<void> check_tiff_format(const OpenTiff& tiff) {
  const int bits = tiff_field<std::uint16_t>(tiff, TIFFTAG_BITSPERSAMPLE);
  const int channels = tiff_field<std::uint16_t>(tiff, TIFFTAG_SAMPLESPERPIXEL);
  const int meaning = tiff_field<std::uint16_t>(tiff, TIFFTAG_SAMPLEFORMAT);
  if (bits != 16 || channels != 1 || meaning != SAMPLEFORMAT_UINT)
    return Error{
        formatted("expected a TIFF with 16 bits of grey per pixel, got %d channels of %d bits, sample format %d",
                  channels, bits, meaning)};
  if (TIFFIsTiled(tiff.get())) return Error{"expected a TIFF in strips, got one in tiles"};
  return {};
}

}  // namespace

Result<GreyImage> read_tiff(std::string_view bytes) {
  TiffReading reading{.bytes = bytes};
  const OpenTiff tiff = open_tiff(reading);
  if (!tiff) return Error{"expected a TIFF, got a damaged one: " + reading.sentence};
  const auto width = tiff_field<std::uint32_t>(tiff, TIFFTAG_IMAGEWIDTH);
  const auto height = tiff_field<std::uint32_t>(tiff, TIFFTAG_IMAGELENGTH);
  if (const Result<void> checked = check_size(width, height); !checked) return checked.failure();
  if (const Result<void> checked = check_tiff_format(tiff); !checked) return checked.failure();

  GreyImage image{static_cast<int>(width), static_cast<int>(height), {}};
  for (std::uint32_t row = 0; row < height; ++row) {
    // row by row, so that a damaged size takes no memory
    image.values.resize(std::size_t{row + 1} * width);
    if (TIFFReadScanline(tiff.get(), &image.values[std::size_t{row} * width], row, 0) != 1)
      return Error{formatted("expected a TIFF, got a damaged one in row %u: ", row) + reading.sentence};
  }
  return image;
}

}  // namespace robot::truth
