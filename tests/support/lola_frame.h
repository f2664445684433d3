// Writes LoLA's sensor frames, as a robot does and as none should.
#pragma once

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "robot/nao/lola/sensors.h"

namespace tests {

/// Key by key; the bytes are a frame once frame() has put a map's head before them.
class LolaFrame {
 public:
  LolaFrame& key(std::string_view name);
  LolaFrame& array(std::size_t count);
  LolaFrame& text(std::string_view text);
  LolaFrame& floating(float number);
  LolaFrame& bytes(std::string_view bytes);

  /// A key and its floats.
  LolaFrame& floats(std::string_view name, const std::vector<float>& numbers);

  /// The four texts that a real robot tells of itself: 20 letters, "6.0.0", twice.
  LolaFrame& identity();

  std::string frame() const;

 private:
  std::string bytes_;
  std::size_t keys_ = 0;
};

/// A frame of 896 bytes, in the order of keys of a real one; every status is a number of one byte, as robots send it.
std::string lola_frame(robot::nao::Sensors sensors);

/// A robot that stands still and is well, in its stand.
robot::nao::Sensors standing_sensors();

}  // namespace tests
