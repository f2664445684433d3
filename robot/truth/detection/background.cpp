#include "robot/truth/detection/background.h"

#include <algorithm>
#include <array>

namespace robot::truth {

void Background::add(const std::vector<std::uint16_t>& depths) {
  if (images_.size() < kMost) {
    images_.push_back(depths);
    return;
  }
  images_[next_] = depths;
  next_ = (next_ + 1) % kMost;
}

std::vector<std::uint16_t> Background::median() const {
  std::vector<std::uint16_t> medians(images_.empty() ? 0 : images_.front().size());
  std::array<std::uint16_t, kMost> measured{};
  for (std::size_t pixel = 0; pixel < medians.size(); ++pixel) {
    auto* end = measured.begin();
    for (const auto& image : images_)
      if (image[pixel] != 0) *end++ = image[pixel];
    const auto count = static_cast<std::size_t>(end - measured.begin());
    if (2 * count < images_.size()) continue;
    auto* const middle = measured.begin() + count / 2;
    std::nth_element(measured.begin(), middle, end);
    medians[pixel] = *middle;
  }
  return medians;
}

}  // namespace robot::truth
