// Numbers in packets: little endian, whatever the processor.
#pragma once

#include <bit>
#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>

namespace robot::game {

/// The first `count` bytes (at most four, at most all) of `bytes` as a number.
inline std::uint32_t number_of(std::string_view bytes, std::size_t count) {
  std::uint32_t number = 0;
  for (std::size_t i = 0; i < bytes.size() && i < count && i < 4; ++i)
    number |= std::uint32_t{static_cast<unsigned char>(bytes[i])} << (8 * i);
  return number;
}

/// Appends the lowest `count` bytes (at most four) of `number`.
inline void put_number(std::string& out, std::uint32_t number, std::size_t count) {
  for (std::size_t i = 0; i < count && i < 4; ++i) out += static_cast<char>(number >> (8 * i) & 255);
}

/// Appends the four bytes of `number`.
inline void put_float(std::string& out, float number) { put_number(out, std::bit_cast<std::uint32_t>(number), 4); }

}  // namespace robot::game
