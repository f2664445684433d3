// A reader for the part of MessagePack that LoLA's frames use. It reads from front to back without copying.
#pragma once

#include <bit>
#include <cstddef>
#include <cstdint>
#include <string_view>

namespace robot::nao {

/// Position and encoding of a number in a frame.
struct NumberSlot {
  enum class Kind : std::uint8_t { in_marker, whole, counting, floating };  // `whole` is signed, `counting` unsigned
  std::uint16_t offset = 0;                                                 // of its marker
  std::uint8_t bytes = 0;                                                   // after the marker: 0, 1, 2, 4 or 8
  Kind kind = Kind::in_marker;
};

/// Reads a number that is not a float of four bytes.
float read_other_number(std::string_view bytes, NumberSlot slot);

/// Returns the number at `slot`, which was found in bytes of the same layout.
inline float read_number(std::string_view bytes, NumberSlot slot) {
  if (slot.kind != NumberSlot::Kind::floating || slot.bytes != 4) return read_other_number(bytes, slot);
  std::uint32_t bits = 0;
  for (std::size_t i = 1; i <= 4; ++i) bits = bits << 8 | static_cast<std::uint8_t>(bytes[slot.offset + i]);
  return std::bit_cast<float>(bits);
}

/// A reader of MessagePack. After the first value of an unexpected type, every result is 0 or empty, and state() says
/// why.
class MessagePackReader {
 public:
  enum class State { good, truncated, wrong };

  /// Reads `bytes`, at most 65535 of them (asserted).
  explicit MessagePackReader(std::string_view bytes);

  /// Returns the number of pairs, or of elements, that follow.
  std::uint32_t map();
  std::uint32_t array();

  std::string_view text();
  NumberSlot number();

  /// Skips one value of any type. More than eight nested levels are wrong.
  void skip() { skip(0); }

  std::size_t position() const { return at_; }
  State state() const { return state_; }

 private:
  std::uint8_t marker();
  std::uint64_t big_endian(std::size_t bytes);
  std::string_view take(std::uint64_t bytes);
  std::uint32_t count(std::uint8_t fix, std::uint8_t fix_bits, std::uint8_t sixteen);
  void skip(int depth);
  void fail(State state);

  std::string_view bytes_;
  std::size_t at_ = 0;
  State state_ = State::good;
};

}  // namespace robot::nao
