#include "robot/truth/sensor/pclzf.h"

#include <cstdint>
#include <string>

#include "robot/core/little_endian.h"
#include "robot/core/text.h"
#include "robot/truth/sensor/lzf.h"

namespace robot::truth {
namespace {

struct PclzfImage {
  std::uint32_t width = 0, height = 0;
  std::string pixels;
};

/// Reads a file of this type. Its header: "PCLZF", width, height, 16 letters of the type, packed and unpacked size.
Result<PclzfImage> read_pclzf(std::string_view bytes, std::string_view type, std::size_t pixel_bytes) {
  ByteReader reader(bytes);
  if (reader.take(5) != "PCLZF")
    return Error{"expected a file that begins with PCLZF, got \"" + printable(bytes.substr(0, 5), 5) + "\""};
  PclzfImage image;
  image.width = reader.number<std::uint32_t>();
  image.height = reader.number<std::uint32_t>();
  const std::string_view letters = reader.take(16);
  const auto packed_size = reader.number<std::uint32_t>();
  const auto size = reader.number<std::uint32_t>();

  if (!reader.ok()) return Error{"expected a header of 37 bytes, got " + std::to_string(bytes.size())};
  if (trimmed(letters.substr(0, letters.find('\0'))) != type)
    return Error{"expected an image of the type " + std::string(type) + ", got \"" + printable(letters, 16) + "\""};
  if (const Result<void> checked = check_size(image.width, image.height); !checked) return checked.failure();
  if (size != std::size_t{image.width} * image.height * pixel_bytes)
    return Error{formatted("expected %zu bytes per pixel of %ux%u px, got %u bytes", pixel_bytes, image.width,
                           image.height, size)};
  if (reader.rest().size() != packed_size)
    return Error{formatted("expected %u bytes behind the header, got %zu", packed_size, reader.rest().size())};

  Result<std::string> pixels = unpack_lzf(reader.rest(), size);
  if (!pixels) return pixels.failure();
  image.pixels = *std::move(pixels);
  return image;
}

}  // namespace

Result<GreyImage> read_pclzf_depth(std::string_view bytes) {
  const Result<PclzfImage> image = read_pclzf(bytes, "depth16", 2);
  if (!image) return image.failure();
  return GreyImage{static_cast<int>(image->width), static_cast<int>(image->height), from_little_endian(image->pixels)};
}

Result<ColourImage> read_pclzf_colour(std::string_view bytes) {
  const Result<PclzfImage> image = read_pclzf(bytes, "rgb24", 3);
  if (!image) return image.failure();
  ColourImage colour{static_cast<int>(image->width), static_cast<int>(image->height), {}};
  colour.rgb.resize(image->pixels.size());
  const std::size_t count = image->pixels.size() / 3;
  for (std::size_t i = 0; i < count; ++i)
    for (std::size_t plane = 0; plane < 3; ++plane)
      colour.rgb[3 * i + plane] = static_cast<std::uint8_t>(image->pixels[plane * count + i]);
  return colour;
}

}  // namespace robot::truth
