// Packets of SSL-Vision for tests, byte by byte from the published field numbers, without our .proto.
#pragma once

#include <bit>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

namespace tests {

inline std::string varint(std::uint64_t value) {
  std::string bytes;
  for (; value >= 0x80; value >>= 7) bytes.push_back(static_cast<char>(value | 0x80));
  bytes.push_back(static_cast<char>(value));
  return bytes;
}

template <class Number>
std::string little_endian(Number bits) {
  std::string bytes;
  for (std::size_t i = 0; i < sizeof bits; ++i) bytes.push_back(static_cast<char>(bits >> (8 * i)));
  return bytes;
}

inline std::string uint_field(unsigned field, std::uint64_t value) { return varint(field << 3) + varint(value); }
inline std::string float_field(unsigned field, float value) {
  return varint(field << 3 | 5) + little_endian(std::bit_cast<std::uint32_t>(value));
}
inline std::string double_field(unsigned field, double value) {
  return varint(field << 3 | 1) + little_endian(std::bit_cast<std::uint64_t>(value));
}
inline std::string message_field(unsigned field, const std::string& bytes) {
  return varint(field << 3 | 2) + varint(bytes.size()) + bytes;
}

struct PacketBall {
  float x = 0, y = 0;  // [mm]
  float confidence = 0.9F;

  std::string bytes() const {
    return float_field(1, confidence) + float_field(3, x) + float_field(4, y) + float_field(6, 1) + float_field(7, 2);
  }
};

struct PacketRobot {
  std::optional<std::uint32_t> id = {};
  float x = 0, y = 0;  // [mm]
  std::optional<float> orientation = {};
  float confidence = 0.9F;

  std::string bytes() const {
    return float_field(1, confidence) + (id ? uint_field(2, *id) : "") + float_field(3, x) + float_field(4, y) +
           (orientation ? float_field(5, *orientation) : "") + float_field(6, 1) + float_field(7, 2);
  }
};

/// A packet with an image. Their clock is far from ours.
struct PacketFrame {
  std::uint32_t camera = 0, frame = 1;
  double sent = 5000;      // [s]
  double latency = 0.008;  // [s]
  std::vector<PacketBall> balls = {};
  std::vector<PacketRobot> yellow = {}, blue = {};

  std::string bytes() const {
    std::string detection =
        uint_field(1, frame) + double_field(2, sent - latency) + double_field(3, sent) + uint_field(4, camera);
    for (const PacketBall& ball : balls) detection += message_field(5, ball.bytes());
    for (const PacketRobot& robot : yellow) detection += message_field(6, robot.bytes());
    for (const PacketRobot& robot : blue) detection += message_field(7, robot.bytes());
    return message_field(1, detection);
  }
};

/// A packet with the size of the field [mm].
inline std::string field_packet(std::uint64_t length, std::uint64_t width, std::uint64_t border) {
  return message_field(2, message_field(1, uint_field(1, length) + uint_field(2, width) + uint_field(3, 1000) +
                                               uint_field(4, 180) + uint_field(5, border)));
}

}  // namespace tests
