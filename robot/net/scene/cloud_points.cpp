#include "robot/net/scene/cloud_points.h"

#include <bit>
#include <cmath>

#include "robot/net/scene/wire.h"

namespace robot::net {
namespace {

Wire packed_field(const char* name, std::uint32_t offset, std::uint64_t type) {
  return Wire().text(1, name).fixed(2, offset).integer(3, type);
}

}  // namespace

void CloudPoints::add(const Point3& place, const Colour& colour) {
  for (const double value : {place.x, place.y, place.z}) {
    const auto bits = std::bit_cast<std::uint32_t>(static_cast<float>(value));
    for (int i = 0; i < 4; ++i) data_.push_back(static_cast<char>(bits >> 8 * i));
  }
  for (const double part : {colour.red, colour.green, colour.blue, colour.alpha})
    data_.push_back(static_cast<char>(std::lround(255 * part)));
}

std::string CloudPoints::message(std::uint64_t capture_ns) const {
  const Wire origin = Wire().number(1, 0).number(2, 0).number(3, 0);
  Wire message;
  message.message(1, timestamp(capture_ns)).text(2, kFieldFrame);
  message.message(3, Wire().message(1, origin).message(2, Wire().number(4, 1))).fixed(4, kStride);
  constexpr std::uint64_t kUint8 = 1, kFloat32 = 7;
  std::uint32_t offset = 0;
  for (const char* name : {"x", "y", "z"}) {
    message.message(5, packed_field(name, offset, kFloat32));
    offset += 4;
  }
  for (const char* name : {"red", "green", "blue", "alpha"}) message.message(5, packed_field(name, offset++, kUint8));
  return message.text(6, data_).bytes();
}

}  // namespace robot::net
