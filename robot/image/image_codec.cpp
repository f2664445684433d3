#include "robot/image/image_codec.h"

// jpeglib.h needs stdio.h before it
#include <cstdio>
// (kept apart so that the order stays)
#include <jpeglib.h>

#include <algorithm>
#include <csetjmp>
#include <memory>
#include <vector>

namespace robot::image {
namespace {

constexpr int kMaxSide = 4096;  // [px]

/// One component of an image. Each row continues with its last value up to whole blocks, as libjpeg reads them.
struct Plane {
  int width, height;  // [px]
  std::size_t stride;
  std::vector<unsigned char> values;

  Plane(int w, int h)
      : width(w),
        height(h),
        stride((static_cast<std::size_t>(w) + DCTSIZE - 1) / DCTSIZE * DCTSIZE),
        values(stride * static_cast<std::size_t>(h)) {}

  unsigned char* row(int y) { return values.data() + stride * static_cast<std::size_t>(y); }

  void fill_up() {
    for (int y = 0; y < height; ++y) std::fill(row(y) + width, row(y) + stride, row(y)[width - 1]);
  }
};

/// One image as three planes, chroma at half the horizontal resolution (4:2:2).
struct Planes {
  Plane y, u, v;

  Planes(int width, int height) : y(width, height), u(width / 2, height), v(width / 2, height) {}
};

Planes split(const unsigned char* yuyv, int width, int height) {
  Planes planes(width, height);
  for (int row = 0; row < height; ++row) {
    unsigned char *y = planes.y.row(row), *u = planes.u.row(row), *v = planes.v.row(row);
    for (int pair = 0; pair < width / 2; ++pair, yuyv += 4) {
      y[2 * pair] = yuyv[0];
      u[pair] = yuyv[1];
      y[2 * pair + 1] = yuyv[2];
      v[pair] = yuyv[3];
    }
  }
  return planes;
}

/// Splits an image and halves its width and height: means of 2x2 pixels, with the chroma of the same area.
Planes split_half(const unsigned char* yuyv, int width, int height) {
  Planes planes(width / 2, height / 2);
  const std::size_t stride = static_cast<std::size_t>(width) * 2;
  for (int row = 0; row < planes.y.height; ++row) {
    const unsigned char* above = yuyv + 2 * static_cast<std::size_t>(row) * stride;
    const unsigned char* below = above + stride;
    const auto mean = [&](int one, int other) {
      return static_cast<unsigned char>((above[one] + above[other] + below[one] + below[other] + 2) / 4);
    };
    unsigned char *y = planes.y.row(row), *u = planes.u.row(row), *v = planes.v.row(row);
    for (int x = 0; x < planes.y.width; ++x) y[x] = mean(4 * x, 4 * x + 2);
    for (int pair = 0; pair < planes.u.width; ++pair) {
      u[pair] = mean(8 * pair + 1, 8 * pair + 5);
      v[pair] = mean(8 * pair + 3, 8 * pair + 7);
    }
  }
  return planes;
}

/// The error handler of libjpeg, which reports errors by longjmp. It keeps the sentence of the error.
struct JpegErrors {
  jpeg_error_mgr manager;
  std::jmp_buf escape;
  char sentence[JMSG_LENGTH_MAX] = "";
};

void leave(j_common_ptr codec) {
  auto* errors = reinterpret_cast<JpegErrors*>(codec->err);
  codec->err->format_message(codec, errors->sentence);
  std::longjmp(errors->escape, 1);
}

// suppresses libjpeg's messages on stderr
void ignore(j_common_ptr, int) {}

jpeg_error_mgr* report_to(JpegErrors& errors) {
  jpeg_error_mgr* manager = jpeg_std_error(&errors.manager);
  manager->error_exit = leave;
  manager->emit_message = ignore;
  return manager;
}

/// A decoder that does not throw: read_header() and read_rows() leave the sentence of an error in `errors`.
struct Decoder {
  jpeg_decompress_struct codec{};
  JpegErrors errors;

  Decoder() { codec.err = report_to(errors); }
  ~Decoder() { jpeg_destroy_decompress(&codec); }
  Decoder(const Decoder&) = delete;
  Decoder& operator=(const Decoder&) = delete;

  Error failure() const { return Error{std::string("JPEG: ") + errors.sentence}; }
};

/// Reads all rows into `rows`, components interleaved. It has only plain data, because longjmp runs no destructors.
bool read_rows(Decoder& reading, std::vector<unsigned char>& rows) {
  if (setjmp(reading.errors.escape)) return false;
  jpeg_decompress_struct& decoder = reading.codec;
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

bool read_header(Decoder& reading, std::string_view jpeg) {
  if (setjmp(reading.errors.escape)) return false;
  jpeg_create_decompress(&reading.codec);
  jpeg_mem_src(&reading.codec, reinterpret_cast<const unsigned char*>(jpeg.data()), jpeg.size());
  jpeg_read_header(&reading.codec, TRUE);
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

/// An encoder that does not throw: write() leaves the sentence of an error in `errors`.
struct Encoder {
  jpeg_compress_struct codec{};
  JpegErrors errors;
  std::unique_ptr<unsigned char[]> buffer;
  unsigned long size = 0;

  /// The buffer holds the largest JPEG of that size: it is no larger than 4 bytes a pixel of whole blocks.
  Encoder(int width, int height) {
    codec.err = report_to(errors);
    const auto whole = [](int pixels, std::size_t block) {
      return (static_cast<std::size_t>(pixels) + block - 1) / block * block;
    };
    size = 4 * whole(width, 2 * DCTSIZE) * whole(height, DCTSIZE) + 2048;
    buffer = std::make_unique_for_overwrite<unsigned char[]>(size);
  }
  ~Encoder() { jpeg_destroy_compress(&codec); }
  Encoder(const Encoder&) = delete;
  Encoder& operator=(const Encoder&) = delete;
};

/// Writes the image into the encoder's buffer. It has only plain data, because longjmp runs no destructors.
bool write(Encoder& writing, Planes& planes, int quality) {
  if (setjmp(writing.errors.escape)) return false;
  jpeg_compress_struct& encoder = writing.codec;
  jpeg_create_compress(&encoder);
  unsigned char* buffer = writing.buffer.get();
  jpeg_mem_dest(&encoder, &buffer, &writing.size);
  encoder.image_width = static_cast<JDIMENSION>(planes.y.width);
  encoder.image_height = static_cast<JDIMENSION>(planes.y.height);
  encoder.input_components = 3;
  encoder.in_color_space = JCS_YCbCr;
  jpeg_set_defaults(&encoder);
  jpeg_set_quality(&encoder, quality, TRUE);
  encoder.comp_info[0].h_samp_factor = 2;
  encoder.comp_info[0].v_samp_factor = 1;
  encoder.raw_data_in = TRUE;
  // the fast method loses more than the quantisation beyond that quality, says libjpeg-turbo's usage.txt
  encoder.dct_method = quality < 96 ? JDCT_IFAST : JDCT_ISLOW;
  jpeg_start_compress(&encoder, TRUE);
  while (encoder.next_scanline < encoder.image_height) {
    JSAMPROW y[DCTSIZE], u[DCTSIZE], v[DCTSIZE];
    JSAMPARRAY rows[] = {y, u, v};
    for (int i = 0; i < DCTSIZE; ++i) {
      const int row = std::min(static_cast<int>(encoder.next_scanline) + i, planes.y.height - 1);
      y[i] = planes.y.row(row);
      u[i] = planes.u.row(row);
      v[i] = planes.v.row(row);
    }
    jpeg_write_raw_data(&encoder, rows, DCTSIZE);
  }
  jpeg_finish_compress(&encoder);
  return true;
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
  Planes planes = half ? split_half(pixels, width, height) : split(pixels, width, height);
  for (Plane* plane : {&planes.y, &planes.u, &planes.v}) plane->fill_up();
  Encoder encoder(planes.y.width, planes.y.height);
  if (!write(encoder, planes, options.quality)) return Error{std::string("JPEG: ") + encoder.errors.sentence};
  return std::string(reinterpret_cast<const char*>(encoder.buffer.get()), encoder.size);
}

Result<ImageSize> size_of_jpeg(std::string_view jpeg) {
  Decoder decoder;
  if (!read_header(decoder, jpeg)) return decoder.failure();
  const int columns = static_cast<int>(decoder.codec.image_width);
  // four components count pairs
  return ImageSize{decoder.codec.num_components == 4 ? 2 * columns : columns,
                   static_cast<int>(decoder.codec.image_height)};
}

Result<YuyvImage> decode_jpeg(std::string_view jpeg) {
  Decoder reading;
  if (!read_header(reading, jpeg)) return reading.failure();
  jpeg_decompress_struct& decoder = reading.codec;
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
  if (!read_rows(reading, rows)) return reading.failure();
  const int width = static_cast<int>(decoder.output_width) * (pairs ? 2 : 1);
  const int height = static_cast<int>(decoder.output_height);
  return YuyvImage{width, height, pairs ? std::string(rows.begin(), rows.end()) : pairs_of(rows)};
}

}  // namespace robot::image
