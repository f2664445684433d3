// Writes recordings in the format of B-Human's robots of 2009, for tests without the real ones.
#pragma once

#include <array>
#include <cstdint>
#include <string>
#include <string_view>

namespace tests {

class Bhuman2009Writer {
 public:
  /// A frame of motion: joint angles with that team's signs [rad], sensors, keys, odometry.
  struct Motion {
    std::uint32_t time_ms = 0;
    std::array<double, 22> angles{};
    std::array<float, 18> sensors{};
    std::array<std::uint16_t, 22> milliamperes{};
    std::array<std::uint8_t, 22> celsius{};
    std::uint32_t sonar_pair = 1;
    std::array<std::uint32_t, 5> keys{};
    std::array<double, 3> odometry{};  // rotation [rad], x, y [mm]
  };
  void motion(const Motion& frame);

  /// A frame of cognition: a JPEG of 2 * `width` x `height` pixels of one colour, and a camera that looks ahead
  /// `tilt` [rad] down from `height_mm`.
  struct Cognition {
    std::uint32_t time_ms = 0;
    std::uint32_t width = 16, height = 8;
    unsigned char y = 100, u = 90, v = 200;
    double tilt = 0, height_mm = 450;
    bool valid = true;
  };
  void cognition(const Cognition& frame);

  /// Any message.
  void message(std::uint8_t id, std::string_view payload);

  /// The whole file.
  std::string file() const;

 private:
  std::string messages_;
  std::uint32_t count_ = 0;
};

}  // namespace tests
