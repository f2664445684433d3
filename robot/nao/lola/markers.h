// The markers of MessagePack: the byte in front of a value names its type. Source:
// https://github.com/msgpack/msgpack/blob/master/spec.md
#pragma once

#include <cstddef>
#include <cstdint>

namespace robot::nao {

enum Marker : std::uint8_t {
  kFixMap = 0x80,
  kFixArray = 0x90,
  kFixText = 0xa0,
  kNil = 0xc0,
  kFalse = 0xc2,
  kTrue = 0xc3,
  kBinary8 = 0xc4,
  kExtension8 = 0xc7,
  kFloat32 = 0xca,
  kFloat64 = 0xcb,
  kCounting8 = 0xcc,
  kWhole8 = 0xd0,
  kFixExtension1 = 0xd4,
  kText8 = 0xd9,
  kArray16 = 0xdc,
  kMap16 = 0xde,
  kNegative = 0xe0,
};

/// Returns the byte of a marker; that of kFixMap, kFixArray and kFixText holds a count of at most 15, 15 and 31.
constexpr char byte_of(Marker marker, std::size_t count = 0) { return static_cast<char>(marker | count); }

}  // namespace robot::nao
