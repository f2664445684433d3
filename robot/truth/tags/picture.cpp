#include "robot/truth/tags/picture.h"

namespace robot::truth::tags {

std::vector<std::uint8_t> grey_of(const Picture& picture) {
  std::vector<std::uint8_t> grey(picture.rgb.size() / 3);
  const std::uint8_t* pixel = picture.rgb.data();
  for (std::uint8_t& brightness : grey) {
    // 77 + 150 + 29 = 256
    brightness = static_cast<std::uint8_t>((77 * pixel[0] + 150 * pixel[1] + 29 * pixel[2] + 128) / 256);
    pixel += 3;
  }
  return grey;
}

}  // namespace robot::truth::tags
