#include "robot/truth/sensor/colour_codec.h"

#include <png.h>
#include <turbojpeg.h>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <string>
#include <vector>

#include "robot/core/text.h"
#include "robot/truth/sensor/netpbm.h"

namespace robot::truth {
namespace {

Result<ColourImage> black_image(const char* format, std::uint64_t width, std::uint64_t height) {
  if (const Result<void> usable = check_size(width, height); !usable) return usable.failure(format);
  return ColourImage{static_cast<int>(width), static_cast<int>(height), std::vector<std::uint8_t>(3 * width * height)};
}

Result<ColourImage> read_colour_png(std::string_view bytes) {
  png_image image{};
  image.version = PNG_IMAGE_VERSION;
  const std::unique_ptr<png_image, void (*)(png_image*)> cleanup(&image, png_image_free);
  if (png_image_begin_read_from_memory(&image, bytes.data(), bytes.size()) == 0)
    return Error{std::string("PNG: ") + image.message};
  image.format = PNG_FORMAT_RGB;
  Result<ColourImage> colours = black_image("PNG", image.width, image.height);
  if (!colours) return colours;
  const png_color behind{0, 0, 0};  // seen through transparent pixels
  if (png_image_finish_read(&image, &behind, colours->rgb.data(), 0, nullptr) == 0)
    return Error{std::string("PNG: ") + image.message};
  return colours;
}

std::uint8_t clamped(int value) { return static_cast<std::uint8_t>(std::clamp(value, 0, 255)); }

/// Writes the colour of one pixel; factors of BT.601 times 65536.
void write_rgb(std::uint8_t* rgb, int y, int u, int v) {
  const int middle = (y << 16) + (1 << 15), blue = u - 128, red = v - 128;
  rgb[0] = clamped((middle + 91881 * red) >> 16);
  rgb[1] = clamped((middle - 22554 * blue - 46802 * red) >> 16);
  rgb[2] = clamped((middle + 116130 * blue) >> 16);
}

}  // namespace

Result<ColourImage> read_colour(std::string_view bytes) {
  if (bytes.starts_with("\xff\xd8")) return read_jpeg(bytes, Damage::refused);
  if (bytes.starts_with("\x89PNG")) return read_colour_png(bytes);
  if (bytes.starts_with("P6")) return read_ppm(bytes);
  return Error{"expected a JPEG, PNG or PPM (P6) picture, got something else"};
}

Result<ColourImage> read_jpeg(std::string_view bytes, Damage damage) {
  const std::unique_ptr<void, void (*)(tjhandle)> decoder(tjInitDecompress(), [](tjhandle used) { tjDestroy(used); });
  const auto* jpeg = reinterpret_cast<const unsigned char*>(bytes.data());
  const auto fault = [&] { return Error{std::string("JPEG: ") + tjGetErrorStr2(decoder.get())}; };
  int width = 0, height = 0, subsampling = 0, colour_space = 0;
  if (tjDecompressHeader3(decoder.get(), jpeg, bytes.size(), &width, &height, &subsampling, &colour_space) != 0)
    return fault();
  Result<ColourImage> colours =
      black_image("JPEG", static_cast<std::uint64_t>(width), static_cast<std::uint64_t>(height));
  if (!colours) return colours;
  const int done = tjDecompress2(decoder.get(), jpeg, bytes.size(), colours->rgb.data(), width, 0, height, TJPF_RGB,
                                 TJFLAG_ACCURATEDCT);
  const bool usable = damage == Damage::accepted && tjGetErrorCode(decoder.get()) == TJERR_WARNING;
  if (done != 0 && !usable) return fault();
  return colours;
}

Result<ColourImage> colour_of_yuyv(std::string_view yuyv, int width, int height) {
  Result<ColourImage> colours =
      black_image("YUYV", static_cast<std::uint64_t>(width), static_cast<std::uint64_t>(height));
  if (!colours) return colours;
  std::vector<std::uint8_t>& rgb = colours->rgb;
  if (width % 2 != 0 || yuyv.size() != rgb.size() / 3 * 2)
    return Error{formatted("YUYV: expected %zu bytes for an even width of %d px, got %zu", rgb.size() / 3 * 2, width,
                           yuyv.size())};
  const auto* pair = reinterpret_cast<const std::uint8_t*>(yuyv.data());
  for (std::size_t i = 0; i < rgb.size(); i += 6, pair += 4) {
    write_rgb(&rgb[i], pair[0], pair[1], pair[3]);
    write_rgb(&rgb[i + 3], pair[2], pair[1], pair[3]);
  }
  return colours;
}

}  // namespace robot::truth
