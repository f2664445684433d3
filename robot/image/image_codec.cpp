#include "robot/image/image_codec.h"

#include <turbojpeg.h>
// jpeglib.h needs stdio.h before it
#include <cstdio>
// (kept apart so that the order stays)
#include <jpeglib.h>

#include <csetjmp>
#include <memory>
#include <vector>

namespace robot::image {
namespace {

constexpr int kMaxSide = 4096;  // [px]

/// One image as three planes, chroma at half the horizontal resolution (4:2:2).
struct Planes {
  int width, height;
  std::vector<unsigned char> y, u, v;

  Planes(int w, int h) : width(w), height(h), y(static_cast<std::size_t>(w * h)), u(y.size() / 2), v(y.size() / 2) {}
};

Planes split(const unsigned char* yuyv, int width, int height) {
  Planes planes(width, height);
  for (std::size_t pair = 0; pair < planes.u.size(); ++pair) {
    planes.y[2 * pair] = yuyv[4 * pair];
    planes.u[pair] = yuyv[4 * pair + 1];
    planes.y[2 * pair + 1] = yuyv[4 * pair + 2];
    planes.v[pair] = yuyv[4 * pair + 3];
  }
  return planes;
}

/// Splits an image and halves its width and height: means of 2x2 pixels, with the chroma of the same area.
Planes split_half(const unsigned char* yuyv, int width, int height) {
  Planes planes(width / 2, height / 2);
  const std::size_t stride = static_cast<std::size_t>(width) * 2;
  for (std::size_t row = 0; row < static_cast<std::size_t>(planes.height); ++row) {
    const unsigned char* above = yuyv + 2 * row * stride;
    const unsigned char* below = above + stride;
    unsigned char* y = &planes.y[row * static_cast<std::size_t>(planes.width)];
    for (std::size_t x = 0; x < static_cast<std::size_t>(planes.width); ++x) {
      const std::size_t at = 4 * x;
      y[x] = static_cast<unsigned char>((above[at] + above[at + 2] + below[at] + below[at + 2] + 2) / 4);
    }
    for (std::size_t pair = 0; pair < static_cast<std::size_t>(planes.width) / 2; ++pair) {
      const std::size_t at = 8 * pair, to = row * static_cast<std::size_t>(planes.width) / 2 + pair;
      planes.u[to] =
          static_cast<unsigned char>((above[at + 1] + above[at + 5] + below[at + 1] + below[at + 5] + 2) / 4);
      planes.v[to] =
          static_cast<unsigned char>((above[at + 3] + above[at + 7] + below[at + 3] + below[at + 7] + 2) / 4);
    }
  }
  return planes;
}

struct Compressor {
  tjhandle handle = tjInitCompress();
  unsigned char* buffer = nullptr;
  unsigned long size = 0;

  ~Compressor() {
    tjFree(buffer);
    if (handle) tjDestroy(handle);
  }
};

/// The error handler of libjpeg, which reports errors by longjmp. It keeps the sentence of the error.
struct JpegErrors {
  jpeg_error_mgr manager;
  std::jmp_buf escape;
  char sentence[JMSG_LENGTH_MAX] = "";
};

void leave(j_common_ptr decoder) {
  auto* errors = reinterpret_cast<JpegErrors*>(decoder->err);
  decoder->err->format_message(decoder, errors->sentence);
  std::longjmp(errors->escape, 1);
}

// suppresses libjpeg's messages on stderr
void ignore(j_common_ptr, int) {}

/// Reads all rows into `rows`, components interleaved. It has only plain data, because longjmp runs no destructors.
bool read_rows(jpeg_decompress_struct& decoder, JpegErrors& errors, std::vector<unsigned char>& rows) {
  if (setjmp(errors.escape)) return false;
  jpeg_start_decompress(&decoder);
  const std::size_t stride =
      static_cast<std::size_t>(decoder.output_width) * static_cast<std::size_t>(decoder.output_components);
  rows.resize(stride * decoder.output_height);
  while (decoder.output_scanline < decoder.output_height) {
    JSAMPROW row = rows.data() + stride * decoder.output_scanline;
    jpeg_read_scanlines(&decoder, &row, 1);
  }
  jpeg_finish_decompress(&decoder);
  return true;
}

bool read_header(jpeg_decompress_struct& decoder, JpegErrors& errors, std::string_view jpeg) {
  if (setjmp(errors.escape)) return false;
  jpeg_create_decompress(&decoder);
  jpeg_mem_src(&decoder, reinterpret_cast<const unsigned char*>(jpeg.data()), jpeg.size());
  jpeg_read_header(&decoder, TRUE);
  return true;
}

/// Converts interleaved Y, Cb, Cr at full resolution to YUYV. The chroma of a pair is the mean of its two pixels.
std::string pairs_of(const std::vector<unsigned char>& ycc) {
  std::string yuyv(ycc.size() / 3 * 2, '\0');
  for (std::size_t pair = 0; pair < yuyv.size() / 4; ++pair) {
    const unsigned char* left = &ycc[6 * pair];
    const unsigned char* right = left + 3;
    yuyv[4 * pair] = static_cast<char>(left[0]);
    yuyv[4 * pair + 1] = static_cast<char>((left[1] + right[1] + 1) / 2);
    yuyv[4 * pair + 2] = static_cast<char>(right[0]);
    yuyv[4 * pair + 3] = static_cast<char>((left[2] + right[2] + 1) / 2);
  }
  return yuyv;
}

}  // namespace

Result<std::string> encode_jpeg(std::string_view yuyv, int width, int height, JpegOptions options) {
  const std::string size = std::to_string(width) + "x" + std::to_string(height);
  if (width < 4 || height < 2 || width > kMaxSide || height > kMaxSide || width % 4 != 0 || height % 2 != 0)
    return Error{"JPEG: expected a width in multiples of 4 and an even height up to 4096 px, got " + size};
  if (yuyv.size() != static_cast<std::size_t>(width) * static_cast<std::size_t>(height) * 2)
    return Error{"JPEG: expected 2 bytes per pixel of a " + size + " image, got " + std::to_string(yuyv.size()) +
                 " bytes"};
  if (options.quality < 1 || options.quality > 100)
    return Error{"JPEG: quality must be 1 .. 100, got " + std::to_string(options.quality)};
  const bool half = options.width == width / 2;
  if (!half && options.width != 0 && options.width != width)
    return Error{"JPEG: expected the width " + std::to_string(width) + " or half of it, got " +
                 std::to_string(options.width)};

  const auto* pixels = reinterpret_cast<const unsigned char*>(yuyv.data());
  const Planes planes = half ? split_half(pixels, width, height) : split(pixels, width, height);
  const unsigned char* sources[] = {planes.y.data(), planes.u.data(), planes.v.data()};
  Compressor compressor;
  if (tjCompressFromYUVPlanes(compressor.handle, sources, planes.width, nullptr, planes.height, TJSAMP_422,
                              &compressor.buffer, &compressor.size, options.quality, TJFLAG_FASTDCT) != 0)
    return Error{std::string("JPEG: ") + tjGetErrorStr2(compressor.handle)};
  return std::string(reinterpret_cast<char*>(compressor.buffer), compressor.size);
}

Result<ImageSize> size_of_jpeg(std::string_view jpeg) {
  const std::unique_ptr<void, void (*)(tjhandle)> decoder(tjInitDecompress(), [](tjhandle used) { tjDestroy(used); });
  ImageSize size;
  int subsampling = 0, colours = 0;
  if (tjDecompressHeader3(decoder.get(), reinterpret_cast<const unsigned char*>(jpeg.data()), jpeg.size(), &size.width,
                          &size.height, &subsampling, &colours) != 0)
    return Error{std::string("JPEG: ") + tjGetErrorStr2(decoder.get())};
  if (colours == TJCS_CMYK || colours == TJCS_YCCK) size.width *= 2;  // they count pairs
  return size;
}

Result<YuyvImage> decode_jpeg(std::string_view jpeg) {
  jpeg_decompress_struct decoder{};
  JpegErrors errors;
  decoder.err = jpeg_std_error(&errors.manager);
  errors.manager.error_exit = leave;
  errors.manager.emit_message = ignore;
  const std::unique_ptr<jpeg_decompress_struct, void (*)(jpeg_decompress_struct*)> cleanup(
      &decoder, [](jpeg_decompress_struct* used) { jpeg_destroy_decompress(used); });

  if (!read_header(decoder, errors, jpeg)) return Error{std::string("JPEG: ") + errors.sentence};
  if (decoder.image_width > kMaxSide || decoder.image_height > kMaxSide || decoder.image_width % 2 != 0)
    return Error{"JPEG: expected an even width and at most 4096 px, got " + std::to_string(decoder.image_width) + "x" +
                 std::to_string(decoder.image_height)};
  const bool pairs = decoder.num_components == 4;
  if (!pairs && decoder.num_components != 3)
    return Error{"JPEG: expected 3 or 4 components, got " + std::to_string(decoder.num_components)};
  // four components are the pixels themselves: prevent a colour conversion
  if (pairs) decoder.jpeg_color_space = JCS_CMYK;
  decoder.out_color_space = pairs ? JCS_CMYK : JCS_YCbCr;
  decoder.dct_method = JDCT_ISLOW;  // the exact method, so that every machine decodes to the same bytes

  std::vector<unsigned char> rows;
  if (!read_rows(decoder, errors, rows)) return Error{std::string("JPEG: ") + errors.sentence};
  const int width = static_cast<int>(decoder.output_width) * (pairs ? 2 : 1);
  const int height = static_cast<int>(decoder.output_height);
  return YuyvImage{width, height, pairs ? std::string(rows.begin(), rows.end()) : pairs_of(rows)};
}

}  // namespace robot::image
