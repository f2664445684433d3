#include "robot/truth/tags/picture_codec.h"

#include <png.h>
#include <turbojpeg.h>

#include <algorithm>
#include <cctype>
#include <charconv>
#include <cstddef>
#include <memory>
#include <optional>
#include <string>

#include "robot/core/text.h"

namespace robot::truth::tags {
namespace {

std::optional<Error> fault_of_size(const char* format, PictureSize size) {
  if (size.width > 0 && size.height > 0 && size.width <= kMostSide && size.height <= kMostSide) return std::nullopt;
  return Error{formatted("%s: expected 1 .. %d px a side, got %dx%d", format, kMostSide, size.width, size.height)};
}

Result<Picture> decode_png_picture(std::string_view bytes) {
  png_image image{};
  image.version = PNG_IMAGE_VERSION;
  const std::unique_ptr<png_image, void (*)(png_image*)> cleanup(&image, png_image_free);
  if (png_image_begin_read_from_memory(&image, bytes.data(), bytes.size()) == 0)
    return Error{std::string("PNG: ") + image.message};
  const PictureSize size{static_cast<int>(std::min<png_uint_32>(image.width, 1 << 30)),
                         static_cast<int>(std::min<png_uint_32>(image.height, 1 << 30))};
  if (const auto fault = fault_of_size("PNG", size)) return *fault;
  image.format = PNG_FORMAT_RGB;
  Picture picture = black_picture(size);
  const png_color behind{0, 0, 0};  // seen through transparent pixels
  if (png_image_finish_read(&image, &behind, picture.rgb.data(), 0, nullptr) == 0)
    return Error{std::string("PNG: ") + image.message};
  return picture;
}

/// The reader of a PPM's head: numbers between blanks and comments.
class PpmHead {
 public:
  explicit PpmHead(std::string_view bytes) : rest_(bytes) { rest_.remove_prefix(2); }

  /// Returns the next number, or -1.
  int number() {
    skip_blanks();
    int value = -1;
    const auto [end, error] = std::from_chars(rest_.data(), rest_.data() + rest_.size(), value);
    rest_.remove_prefix(static_cast<std::size_t>(end - rest_.data()));
    return error == std::errc() ? value : -1;
  }

  /// Returns the bytes after the head: one blank ends it.
  std::string_view pixels() const { return rest_.empty() ? rest_ : rest_.substr(1); }

 private:
  void skip_blanks() {
    while (!rest_.empty() && (std::isspace(static_cast<unsigned char>(rest_[0])) != 0 || rest_[0] == '#'))
      rest_.remove_prefix(rest_[0] == '#' ? std::min(rest_.find('\n'), rest_.size()) : 1);
  }

  std::string_view rest_;
};

Result<Picture> decode_ppm_picture(std::string_view bytes) {
  PpmHead head(bytes);
  const int width = head.number(), height = head.number(), most = head.number();
  const PictureSize size{width, height};
  if (const auto fault = fault_of_size("PPM", size)) return *fault;
  if (most != 255) return Error{formatted("PPM: expected 255 as greatest value, got %d", most)};
  Picture picture = black_picture(size);
  const std::string_view pixels = head.pixels();
  if (pixels.size() < picture.rgb.size())
    return Error{formatted("PPM: expected %zu bytes of pixels, got %zu", picture.rgb.size(), pixels.size())};
  std::copy_n(pixels.begin(), picture.rgb.size(), picture.rgb.begin());
  return picture;
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

Result<Picture> decode_picture(std::string_view bytes) {
  if (bytes.starts_with("\xff\xd8")) return decode_jpeg_picture(bytes, Damage::refused);
  if (bytes.starts_with("\x89PNG")) return decode_png_picture(bytes);
  if (bytes.starts_with("P6")) return decode_ppm_picture(bytes);
  return Error{"expected a JPEG, PNG or PPM (P6) picture, got something else"};
}

Result<Picture> decode_jpeg_picture(std::string_view bytes, Damage damage) {
  const std::unique_ptr<void, void (*)(tjhandle)> decoder(tjInitDecompress(), [](tjhandle used) { tjDestroy(used); });
  const auto* jpeg = reinterpret_cast<const unsigned char*>(bytes.data());
  const auto fault = [&] { return Error{std::string("JPEG: ") + tjGetErrorStr2(decoder.get())}; };
  PictureSize size;
  int subsampling = 0, colours = 0;
  if (tjDecompressHeader3(decoder.get(), jpeg, bytes.size(), &size.width, &size.height, &subsampling, &colours) != 0)
    return fault();
  if (const auto wrong = fault_of_size("JPEG", size)) return *wrong;
  Picture picture = black_picture(size);
  const int done = tjDecompress2(decoder.get(), jpeg, bytes.size(), picture.rgb.data(), size.width, 0, size.height,
                                 TJPF_RGB, TJFLAG_ACCURATEDCT);
  const bool usable = damage == Damage::accepted && tjGetErrorCode(decoder.get()) == TJERR_WARNING;
  if (done != 0 && !usable) return fault();
  return picture;
}

Result<Picture> picture_of_yuyv(std::string_view yuyv, PictureSize size) {
  if (const auto fault = fault_of_size("YUYV", size)) return *fault;
  Picture picture = black_picture(size);
  if (size.width % 2 != 0 || yuyv.size() != picture.rgb.size() / 3 * 2)
    return Error{formatted("YUYV: expected %zu bytes for an even width of %d px, got %zu", picture.rgb.size() / 3 * 2,
                           size.width, yuyv.size())};
  const auto* pair = reinterpret_cast<const std::uint8_t*>(yuyv.data());
  for (std::size_t i = 0; i < picture.rgb.size(); i += 6, pair += 4) {
    write_rgb(&picture.rgb[i], pair[0], pair[1], pair[3]);
    write_rgb(&picture.rgb[i + 3], pair[2], pair[1], pair[3]);
  }
  return picture;
}

}  // namespace robot::truth::tags
