#include "tests/robot/truth/sensor/depth_files.h"

#include <png.h>
#include <tiffio.h>

#include <algorithm>
#include <cstdio>
#include <cstdlib>
#include <iterator>

#include "robot/core/little_endian.h"
#include "robot/core/text.h"
#include "tests/support/temporary_folder.h"

namespace tests {
namespace {

using robot::put;
using robot::truth::ColourImage;
using robot::truth::GreyImage;

std::string big_endian_bytes(const std::vector<std::uint16_t>& values) {
  std::string bytes;
  for (const std::uint16_t value : values) bytes += {static_cast<char>(value >> 8), static_cast<char>(value & 0xff)};
  return bytes;
}

std::string little_endian_bytes(const std::vector<std::uint16_t>& values) {
  std::string bytes;
  for (const std::uint16_t value : values) put(bytes, value);
  return bytes;
}

void append_png_bytes(png_structp png, png_bytep bytes, std::size_t size) {
  static_cast<std::string*>(png_get_io_ptr(png))->append(reinterpret_cast<const char*>(bytes), size);
}

std::string png_of_rows(std::string rows, int width, int height, int bits, int colours, bool interlaced) {
  std::string bytes;
  png_structp png = png_create_write_struct(PNG_LIBPNG_VER_STRING, nullptr, nullptr, nullptr);
  png_infop info = png_create_info_struct(png);
  png_set_write_fn(png, &bytes, append_png_bytes, nullptr);
  png_set_IHDR(png, info, static_cast<png_uint_32>(width), static_cast<png_uint_32>(height), bits, colours,
               interlaced ? PNG_INTERLACE_ADAM7 : PNG_INTERLACE_NONE, PNG_COMPRESSION_TYPE_DEFAULT,
               PNG_FILTER_TYPE_DEFAULT);
  png_write_info(png, info);
  const std::size_t row_bytes = rows.size() / static_cast<std::size_t>(height);
  const int passes = png_set_interlace_handling(png);
  for (int pass = 0; pass < passes; ++pass)
    for (std::size_t row = 0; row < static_cast<std::size_t>(height); ++row)
      png_write_row(png, reinterpret_cast<png_bytep>(&rows[row * row_bytes]));
  png_write_end(png, info);
  png_destroy_write_struct(&png, &info);
  return bytes;
}

/// Returns the file that `write` fills.
template <class Write>
std::string tiff_by(const char* mode, const Write& write) {
  const TemporaryFolder folder;
  const std::string path = folder / "image.tiff";
  TIFF* tiff = TIFFOpen(path.c_str(), mode);
  write(tiff);
  TIFFClose(tiff);
  std::ifstream file(path, std::ios::binary);
  return {std::istreambuf_iterator<char>(file), {}};
}

void set_fields(TIFF* tiff, const GreyImage& image) {
  TIFFSetField(tiff, TIFFTAG_IMAGEWIDTH, image.width);
  TIFFSetField(tiff, TIFFTAG_IMAGELENGTH, image.height);
  TIFFSetField(tiff, TIFFTAG_BITSPERSAMPLE, 16);
  TIFFSetField(tiff, TIFFTAG_SAMPLESPERPIXEL, 1);
  TIFFSetField(tiff, TIFFTAG_PHOTOMETRIC, PHOTOMETRIC_MINISBLACK);
}

/// Returns LZF data: a repetition of the two bytes before becomes a reference, all other bytes stay as they are.
std::string packed(const std::string& bytes) {
  std::string out, plain;
  const auto flush = [&] {
    if (!plain.empty()) out += static_cast<char>(plain.size() - 1) + plain;
    plain.clear();
  };
  for (std::size_t at = 0; at < bytes.size();) {
    std::size_t length = 0;
    while (at >= 2 && length < 264 && at + length < bytes.size() && bytes[at + length] == bytes[at + length - 2])
      ++length;
    if (length < 3) {
      plain += bytes[at++];
      if (plain.size() == 32) flush();
      continue;
    }
    flush();
    // the length less 2 in three bits, or 7 and the rest in a byte of its own; then the distance less 1
    if (length < 9)
      out += static_cast<char>((length - 2) << 5);
    else
      out += {static_cast<char>(7 << 5), static_cast<char>(length - 9)};
    out += '\1';
    at += length;
  }
  flush();
  return out;
}

std::string pclzf_of_bytes(const std::string& bytes, int width, int height, std::string type) {
  const std::string data = packed(bytes);
  type.resize(16, ' ');
  std::string file = "PCLZF";
  put(file, static_cast<std::uint32_t>(width));
  put(file, static_cast<std::uint32_t>(height));
  file += type;
  put(file, static_cast<std::uint32_t>(data.size()));
  put(file, static_cast<std::uint32_t>(bytes.size()));
  return file + data;
}

}  // namespace

GreyImage grey_image(int width, int height, std::uint16_t greatest) {
  GreyImage image{width, height, std::vector<std::uint16_t>(static_cast<std::size_t>(width * height))};
  for (std::size_t i = 0; i < image.values.size(); ++i)
    image.values[i] = static_cast<std::uint16_t>(i % 7 < 4 ? 300 : (i * 7919 + 5) % (greatest + std::size_t{1}));
  return image;
}

ColourImage colour_image(int width, int height) {
  ColourImage image{width, height, std::vector<std::uint8_t>(static_cast<std::size_t>(3 * width * height))};
  for (std::size_t i = 0; i < image.rgb.size(); ++i) image.rgb[i] = static_cast<std::uint8_t>(i * 31 + i / 256);
  return image;
}

std::string pgm_of(const GreyImage& image) {
  return robot::formatted("P5 %d %d 65535\n", image.width, image.height) + big_endian_bytes(image.values);
}

std::string fakenect_pgm_of(const GreyImage& image) {
  return robot::formatted("P5 %d %d 65535\n", image.width, image.height) + little_endian_bytes(image.values);
}

std::string ppm_of(const ColourImage& image) {
  return robot::formatted("P6 %d %d 255\n", image.width, image.height) +
         std::string(image.rgb.begin(), image.rgb.end());
}

std::string png_of(const GreyImage& image, bool interlaced) {
  return png_of_rows(big_endian_bytes(image.values), image.width, image.height, 16, PNG_COLOR_TYPE_GRAY, interlaced);
}

std::string png_of(const ColourImage& image) {
  return png_of_rows({image.rgb.begin(), image.rgb.end()}, image.width, image.height, 8, PNG_COLOR_TYPE_RGB, false);
}

std::string tiff_of(const GreyImage& image, int compression, bool big_endian) {
  return tiff_by(big_endian ? "wb" : "wl", [&](TIFF* tiff) {
    set_fields(tiff, image);
    TIFFSetField(tiff, TIFFTAG_COMPRESSION, compression);
    TIFFSetField(tiff, TIFFTAG_ROWSPERSTRIP, 2);
    std::vector<std::uint16_t> values = image.values;
    for (int row = 0; row < image.height; ++row)
      TIFFWriteScanline(tiff, &values[static_cast<std::size_t>(row * image.width)], static_cast<std::uint32_t>(row));
  });
}

std::string tiff_in_tiles_of(const GreyImage& image) {
  return tiff_by("w", [&](TIFF* tiff) {
    set_fields(tiff, image);
    TIFFSetField(tiff, TIFFTAG_TILEWIDTH, 16);
    TIFFSetField(tiff, TIFFTAG_TILELENGTH, 16);
    std::vector<std::uint16_t> tile(16 * 16);
    TIFFWriteTile(tiff, tile.data(), 0, 0, 0, 0);
  });
}

std::string pclzf_of(const GreyImage& image) {
  return pclzf_of_bytes(little_endian_bytes(image.values), image.width, image.height, "depth16");
}

std::string pclzf_of(const ColourImage& image) {
  std::string planes;
  for (std::size_t plane = 0; plane < 3; ++plane)
    for (std::size_t i = plane; i < image.rgb.size(); i += 3) planes += static_cast<char>(image.rgb[i]);
  return pclzf_of_bytes(planes, image.width, image.height, "rgb24");
}

std::string pcl_xml(double focal, double centre_x, double centre_y) {
  return robot::formatted(
      "<?xml version=\"1.0\"?>\n<rgb>\n\t<focal_length_x>1</focal_length_x>\n</rgb>\n<depth>\n"
      "\t<focal_length_x>%g</focal_length_x>\n\t<focal_length_y>%g</focal_length_y>\n"
      "\t<principal_point_x>%g</principal_point_x>\n\t<principal_point_y>%g</principal_point_y>\n"
      "\t<z_multiplication_factor>0.002</z_multiplication_factor>\n</depth>\n",
      focal, focal, centre_x, centre_y);
}

void write_file(const std::filesystem::path& path, std::string_view bytes) {
  std::ofstream(path, std::ios::binary) << bytes;
}

}  // namespace tests
