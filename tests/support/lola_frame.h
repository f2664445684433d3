// Writes LoLA's sensor frames, correct and broken ones.
#pragma once

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "robot/nao/lola/sensors.h"

namespace tests {

/// Writes a frame key by key. frame() puts the head of a map before the bytes.
class LolaFrame {
 public:
  LolaFrame& key(std::string_view name);
  LolaFrame& array(std::size_t count);
  LolaFrame& text(std::string_view text);
  LolaFrame& floating(float number);
  LolaFrame& bytes(std::string_view bytes);

  /// A key and its floats.
  LolaFrame& floats(std::string_view name, const std::vector<float>& numbers);

  /// Writes the four identity texts of a real robot: 20 letters, "6.0.0", twice.
  LolaFrame& identity();

  std::string frame() const;

 private:
  std::string bytes_;
  std::size_t keys_ = 0;
};

/// Returns a frame of 896 bytes in the key order of a real one. Every status is a number of one byte, as robots send it.
std::string lola_frame(robot::nao::Sensors sensors);

/// Returns the values of a healthy robot that stands still.
robot::nao::Sensors standing_sensors();

}  // namespace tests
