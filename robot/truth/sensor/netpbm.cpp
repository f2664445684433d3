#include "robot/truth/sensor/netpbm.h"

#include <charconv>
#include <cstdint>
#include <string>

#include "robot/core/text.h"

namespace robot::truth {
namespace {

constexpr std::string_view kBlanks = " \t\r\n\v\f";

/// An image behind its header.
struct NetpbmImage {
  std::uint32_t width = 0, height = 0, greatest = 0;
  std::string_view pixels;
};

/// Removes blanks and comments at the beginning of `text`.
void skip_blanks(std::string_view& text) {
  while (!text.empty()) {
    if (kBlanks.find(text.front()) != std::string_view::npos)
      text.remove_prefix(1);
    else if (text.front() == '#')
      text.remove_prefix(std::min(text.find('\n'), text.size()));
    else
      return;
  }
}

/// Reads the next number of a header. Returns false if there is none.
bool read_number(std::string_view& text, std::uint32_t& number) {
  skip_blanks(text);
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), number);
  text.remove_prefix(static_cast<std::size_t>(end - text.data()));
  return error == std::errc();
}

/// Reads the header of an image that begins with `magic` and checks the number of bytes behind it.
Result<NetpbmImage> read_netpbm(std::string_view bytes, std::string_view magic, std::size_t pixel_bytes) {
  const std::string_view start = bytes.substr(0, magic.size());
  if (start != magic)
    return Error{"expected an image that begins with " + std::string(magic) + ", got \"" + printable(start, 2) + "\""};
  bytes.remove_prefix(magic.size());
  NetpbmImage image;
  if (!read_number(bytes, image.width) || !read_number(bytes, image.height) || !read_number(bytes, image.greatest) ||
      bytes.empty() || kBlanks.find(bytes.front()) == std::string_view::npos)
    return Error{"expected width, height and greatest value behind " + std::string(magic) + ", got a damaged header"};
  if (const Result<void> checked = check_size(image.width, image.height); !checked) return checked.failure();

  image.pixels = bytes.substr(1);
  const std::size_t expected = std::size_t{image.width} * image.height * pixel_bytes;
  if (image.pixels.size() != expected)
    return Error{formatted("expected %zu bytes of pixels of %ux%u px, got %zu", expected, image.width, image.height,
                           image.pixels.size())};
  return image;
}

/// Reads a PGM whose pixels have 16 bits.
Result<NetpbmImage> read_grey(std::string_view bytes) {
  Result<NetpbmImage> image = read_netpbm(bytes, "P5", 2);
  if (image && (image->greatest < 256 || image->greatest > 65535))
    return Error{formatted("expected 16 bits per pixel (a greatest value of 256 to 65535), got %u", image->greatest)};
  return image;
}

}  // namespace

Result<GreyImage> read_pgm(std::string_view bytes) {
  const Result<NetpbmImage> image = read_grey(bytes);
  if (!image) return image.failure();
  return GreyImage{static_cast<int>(image->width), static_cast<int>(image->height), from_big_endian(image->pixels)};
}

Result<GreyImage> read_fakenect_pgm(std::string_view bytes) {
  const Result<NetpbmImage> image = read_grey(bytes);
  if (!image) return image.failure();
  return GreyImage{static_cast<int>(image->width), static_cast<int>(image->height), from_little_endian(image->pixels)};
}

Result<ColourImage> read_ppm(std::string_view bytes) {
  const Result<NetpbmImage> image = read_netpbm(bytes, "P6", 3);
  if (!image) return image.failure();
  if (image->greatest != 255) return Error{formatted("expected a greatest value of 255, got %u", image->greatest)};
  return ColourImage{
      static_cast<int>(image->width), static_cast<int>(image->height), {image->pixels.begin(), image->pixels.end()}};
}

}  // namespace robot::truth
