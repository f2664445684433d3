#include "robot/truth/sensor/image.h"

#include <string>

#include "robot/core/text.h"

namespace robot::truth {
namespace {

/// Returns the 16-bit values whose more significant byte is at the odd (1) or even (0) places.
std::vector<std::uint16_t> pairs_of_bytes(std::string_view bytes, std::size_t high) {
  std::vector<std::uint16_t> values(bytes.size() / 2);
  for (std::size_t i = 0; i < values.size(); ++i) {
    const auto above = static_cast<std::uint8_t>(bytes[2 * i + high]);
    const auto below = static_cast<std::uint8_t>(bytes[2 * i + 1 - high]);
    values[i] = static_cast<std::uint16_t>(above << 8 | below);
  }
  return values;
}

}  // namespace

Result<void> check_size(std::uint64_t width, std::uint64_t height) {
  if (width >= 1 && height >= 1 && width <= kMaxSide && height <= kMaxSide) return {};
  return Error{formatted("expected an image of 1x1 to %dx%d px, got %llux%llu", kMaxSide, kMaxSide,
                         static_cast<unsigned long long>(width), static_cast<unsigned long long>(height))};
}

std::vector<std::uint16_t> from_big_endian(std::string_view bytes) { return pairs_of_bytes(bytes, 0); }

std::vector<std::uint16_t> from_little_endian(std::string_view bytes) { return pairs_of_bytes(bytes, 1); }

}  // namespace robot::truth
