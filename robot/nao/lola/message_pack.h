// MessagePack, as far as LoLA's frames need it: read from front to back, without copying.
#pragma once

#include <bit>
#include <cstddef>
#include <cstdint>
#include <string_view>

namespace robot::nao {

/// Where a number lies in a frame, and how it is written.
struct NumberSlot {
  enum class Kind : std::uint8_t { in_marker, whole, counting, floating };  // `whole` has a sign, `counting` has none
  std::uint16_t offset = 0;                                                 // of its marker
  std::uint8_t bytes = 0;                                                   // behind the marker: 0, 1, 2, 4 or 8
  Kind kind = Kind::in_marker;
};

/// Those that are no float of four bytes.
float read_other_number(std::string_view bytes, NumberSlot slot);

/// The number at `slot`, which was found in bytes laid out like these.
inline float read_number(std::string_view bytes, NumberSlot slot) {
  if (slot.kind != NumberSlot::Kind::floating || slot.bytes != 4) return read_other_number(bytes, slot);
  std::uint32_t bits = 0;
  for (std::size_t i = 1; i <= 4; ++i) bits = bits << 8 | static_cast<std::uint8_t>(bytes[slot.offset + i]);
  return std::bit_cast<float>(bits);
}

/// After the first thing that is not as asked for, all is 0 or empty, and state() says what was wrong.
class MessagePackReader {
 public:
  enum class State { good, truncated, wrong };

  /// At most 65535 bytes (asserted).
  explicit MessagePackReader(std::string_view bytes);

  /// How many pairs, or elements, follow.
  std::uint32_t map();
  std::uint32_t array();

  std::string_view text();
  NumberSlot number();

  /// Passes over one value, whatever it is; beyond eight levels within each other it is wrong.
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
