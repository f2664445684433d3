#include "robot/truth/sensor/png.h"

#include <png.h>

#include <algorithm>
#include <csetjmp>
#include <cstring>
#include <string>

#include "robot/core/text.h"

namespace robot::truth {
namespace {

/// One reading of a PNG. libpng leaves it by longjmp, which runs no destructors; so all of its data lie here.
struct PngReading {
  explicit PngReading(std::string_view bytes) : rest(bytes) {}
  PngReading(const PngReading&) = delete;
  PngReading& operator=(const PngReading&) = delete;
  ~PngReading() { png_destroy_read_struct(&png, &info, nullptr); }

  std::string_view rest;  // bytes that libpng has not read
  png_structp png = nullptr;
  png_infop info = nullptr;
  char sentence[160] = "";  // of the error
  std::string rows;
};

[[noreturn]] void leave_png(png_structp png, png_const_charp message) {
  auto& reading = *static_cast<PngReading*>(png_get_error_ptr(png));
  std::strncpy(reading.sentence, message, sizeof reading.sentence - 1);
  png_longjmp(png, 1);
}

// suppresses libpng's messages on stderr
void ignore_png_warning(png_structp, png_const_charp) {}

void take_png_bytes(png_structp png, png_bytep into, std::size_t size) {
  auto& reading = *static_cast<PngReading*>(png_get_io_ptr(png));
  if (size > reading.rest.size()) png_error(png, "the file is truncated");
  std::memcpy(into, reading.rest.data(), size);
  reading.rest.remove_prefix(size);
}

bool read_png_header(PngReading& reading) {
  reading.png = png_create_read_struct(PNG_LIBPNG_VER_STRING, &reading, leave_png, ignore_png_warning);
  reading.info = reading.png ? png_create_info_struct(reading.png) : nullptr;
  if (!reading.info || setjmp(png_jmpbuf(reading.png))) return false;
  png_set_read_fn(reading.png, &reading, take_png_bytes);
  png_read_info(reading.png, reading.info);
  return true;
}

bool read_png_rows(PngReading& reading) {
  if (setjmp(png_jmpbuf(reading.png))) return false;
  const int passes = png_set_interlace_handling(reading.png);
  png_read_update_info(reading.png, reading.info);
  const std::size_t row_bytes = png_get_rowbytes(reading.png, reading.info);
  const std::size_t height = png_get_image_height(reading.png, reading.info);
  reading.rows.resize(row_bytes * height);
  for (int pass = 0; pass < passes; ++pass)
    for (std::size_t row = 0; row < height; ++row)
      png_read_row(reading.png, reinterpret_cast<png_bytep>(&reading.rows[row * row_bytes]), nullptr);
  png_read_end(reading.png, nullptr);
  return true;
}

}  // namespace

Result<GreyImage> read_png(std::string_view bytes) {
  PngReading reading(bytes);
  if (!read_png_header(reading)) return Error{std::string("expected a PNG, got a damaged one: ") + reading.sentence};
  const png_uint_32 width = png_get_image_width(reading.png, reading.info);
  const png_uint_32 height = png_get_image_height(reading.png, reading.info);
  if (const Result<void> checked = check_size(width, height); !checked) return checked.failure();
  const int bits = png_get_bit_depth(reading.png, reading.info);
  const int channels = png_get_channels(reading.png, reading.info);
  if (bits != 16 || channels != 1)
    return Error{
        formatted("expected a PNG with 16 bits of grey per pixel, got %d channels of %d bits", channels, bits)};
  if (!read_png_rows(reading)) return Error{std::string("expected a PNG, got a damaged one: ") + reading.sentence};
  return GreyImage{static_cast<int>(width), static_cast<int>(height), from_big_endian(reading.rows)};
}

}  // namespace robot::truth
