#include "robot/truth/tags/spots.h"

#include <algorithm>
#include <cstdint>
#include <utility>

namespace robot::truth::tags {
namespace {

constexpr std::size_t kMostPixels = 40'000;

/// Returns whether a colour is within the range.
bool is_of_colour(const std::uint8_t* rgb, const ColourRange& colours) {
  const int r = rgb[0], g = rgb[1], b = rgb[2];
  const int most = std::max({r, g, b}), least = std::min({r, g, b}), chroma = most - least;
  if (most < 255 * colours.least_brightness || chroma < most * colours.least_saturation || chroma == 0) return false;
  const double sector = most == r ? 0 : most == g ? 120 : 240;
  const int ahead = most == r ? g - b : most == g ? b - r : r - g;
  const double hue = sector + 60.0 * ahead / chroma;
  const double hue_deg = hue < 0 ? hue + 360 : hue;
  if (colours.hue_from_deg > colours.hue_to_deg)
    return hue_deg >= colours.hue_from_deg || hue_deg <= colours.hue_to_deg;
  return hue_deg >= colours.hue_from_deg && hue_deg <= colours.hue_to_deg;
}

/// The marked pixels of a picture.
class Marks {
 public:
  Marks(const DepthFrame& picture, const ColourRange& colours)
      : width_(picture.intrinsics.width), height_(picture.intrinsics.height), marked_(picture.rgb.size() / 3) {
    for (std::size_t i = 0; i < marked_.size(); ++i) marked_[i] = is_of_colour(&picture.rgb[3 * i], colours) ? 1 : 0;
  }

  std::size_t count() const { return marked_.size(); }
  bool is_marked(std::size_t pixel) const { return marked_[pixel] != 0; }

  /// Removes the spot that contains the pixel `start`, and returns its pixels.
  Spot take(std::size_t start) {
    Spot spot;
    std::vector<std::size_t> open;
    visit(start, open);
    while (!open.empty()) {
      const auto x = static_cast<int>(open.back() % static_cast<std::size_t>(width_));
      const auto y = static_cast<int>(open.back() / static_cast<std::size_t>(width_));
      open.pop_back();
      if (spot.size() <= kMostPixels) spot.emplace_back(x + 0.5, y + 0.5);
      for (int to_y = std::max(0, y - 1); to_y <= std::min(height_ - 1, y + 1); ++to_y)
        for (int to_x = std::max(0, x - 1); to_x <= std::min(width_ - 1, x + 1); ++to_x)
          visit(static_cast<std::size_t>(to_y) * static_cast<std::size_t>(width_) + static_cast<std::size_t>(to_x),
                open);
    }
    return spot;
  }

 private:
  void visit(std::size_t pixel, std::vector<std::size_t>& open) {
    if (marked_[pixel] == 0) return;
    marked_[pixel] = 0;
    open.push_back(pixel);
  }

  int width_, height_;  // [px]
  std::vector<std::uint8_t> marked_;
};

}  // namespace

std::vector<Spot> spots_of_colour(const DepthFrame& picture, const ColourRange& colours, std::size_t fewest) {
  std::vector<Spot> spots;
  Marks marks(picture, colours);
  for (std::size_t pixel = 0; pixel < marks.count(); ++pixel) {
    if (!marks.is_marked(pixel)) continue;
    Spot spot = marks.take(pixel);
    if (spot.size() >= fewest && spot.size() <= kMostPixels) spots.push_back(std::move(spot));
  }
  return spots;
}

}  // namespace robot::truth::tags
