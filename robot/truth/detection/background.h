// The depths of the empty field, learned from images.
#pragma once

#include <cstdint>
#include <vector>

namespace robot::truth {

/// The median of recent depth images. A person who walks through less than half of them leaves no trace.
class Background {
 public:
  /// The newest images count: 15 keep 9 MB and reduce the noise by a factor of 3.
  static constexpr std::size_t kMost = 15;

  /// Returns the number of images that count.
  std::size_t images() const { return images_.size(); }

  /// Adds an image. All images have the same size.
  void add(const std::vector<std::uint16_t>& depths);

  /// Returns the median of each pixel's measured depths, or 0 where fewer than half of the images measured one.
  std::vector<std::uint16_t> median() const;

 private:
  std::vector<std::vector<std::uint16_t>> images_;
  std::size_t next_ = 0;  // the place of the next image once there are kMost
};

}  // namespace robot::truth
