#include "robot/net/scene/wire.h"

#include <bit>

#include "robot/core/clock.h"

namespace robot::net {
namespace {

// the wire types of protobuf
constexpr int kVarint = 0, kEightBytes = 1, kLength = 2, kFourBytes = 5;

}  // namespace

void Wire::varint(std::uint64_t value) {
  for (; value >= 0x80; value >>= 7) bytes_.push_back(static_cast<char>(value | 0x80));
  bytes_.push_back(static_cast<char>(value));
}

void Wire::little_endian(std::uint64_t value, int bytes) {
  for (int i = 0; i < bytes; ++i) bytes_.push_back(static_cast<char>(value >> 8 * i));
}

Wire& Wire::number(int field, double value) {
  tag(field, kEightBytes);
  little_endian(std::bit_cast<std::uint64_t>(value), 8);
  return *this;
}

Wire& Wire::numbers(int field, std::span<const double> values) {
  tag(field, kLength);
  varint(8 * values.size());
  for (const double value : values) little_endian(std::bit_cast<std::uint64_t>(value), 8);
  return *this;
}

Wire& Wire::integer(int field, std::uint64_t value) {
  tag(field, kVarint);
  varint(value);
  return *this;
}

Wire& Wire::fixed(int field, std::uint32_t value) {
  tag(field, kFourBytes);
  little_endian(value, 4);
  return *this;
}

Wire& Wire::text(int field, std::string_view value) {
  tag(field, kLength);
  varint(value.size());
  bytes_.append(value);
  return *this;
}

Wire timestamp(std::uint64_t ns) { return Wire().integer(1, ns / kSecond).integer(2, ns % kSecond); }

}  // namespace robot::net
