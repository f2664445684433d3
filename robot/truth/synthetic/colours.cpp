#include "robot/truth/synthetic/colours.h"

#include <algorithm>
#include <array>
#include <cstddef>

#include "robot/truth/synthetic/random_bits.h"

namespace robot::truth {
namespace {

using Colour = std::array<std::uint8_t, 3>;

constexpr Colour colour_of(Material material) {
  switch (material) {
    case Material::nothing: return {40, 40, 45};
    case Material::carpet: return {40, 120, 50};
    case Material::line: return {225, 230, 225};
    case Material::wall: return {150, 140, 130};
    case Material::post: return {235, 235, 230};
    case Material::robot: return {205, 205, 215};
    case Material::person: return {35, 35, 50};
    case Material::orange: return {235, 110, 25};
    case Material::white: return {230, 230, 230};
    case Material::black:
    case Material::patches: return {30, 30, 30};
  }
  return {};
}

constexpr std::uint32_t kOneIn20 = 65536 / 20;
constexpr std::size_t kPixelsOfOneFault = 100'000;

void paint_pixel(Material material, std::uint8_t* rgb) {
  const Colour colour = colour_of(material);
  std::copy(colour.begin(), colour.end(), rgb);
}

}  // namespace

void paint(const Cast& cast, std::uint64_t number, DepthFrame& frame) {
  const auto width = static_cast<std::size_t>(frame.intrinsics.width);
  const std::size_t pixels = cast.material.size();
  RandomBits bits(~number);
  frame.rgb.resize(3 * pixels);
  for (std::size_t row = 0; row < pixels; row += width)
    for (std::size_t column = 0; column < width; ++column) {
      const Material shown = cast.material[row + (column > 0 ? column - 1 : 0)];
      const bool fault = shown == Material::orange && bits.next() < kOneIn20;
      paint_pixel(fault ? Material::carpet : shown, &frame.rgb[3 * (row + column)]);
    }
  for (std::size_t i = 0; i < pixels / kPixelsOfOneFault; ++i) {
    const std::size_t pixel = (static_cast<std::size_t>(bits.next()) << 16 | bits.next()) % pixels;
    paint_pixel(Material::orange, &frame.rgb[3 * pixel]);
  }
}

}  // namespace robot::truth
