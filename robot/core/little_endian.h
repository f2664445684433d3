// Numbers as bytes in packets and files: little endian on every processor.
#pragma once

#include <bit>
#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>
#include <type_traits>

namespace robot {

/// Appends the lowest `size` bytes (at most eight) of `value`.
inline void put(std::string& out, std::uint64_t value, std::size_t size) {
  char bytes[sizeof value];
  for (std::size_t i = 0; i < size; ++i) bytes[i] = static_cast<char>(value >> (8 * i) & 0xff);
  out.append(bytes, size);
}

/// Appends `value`, an integer or a float.
template <class Number>
void put(std::string& out, Number value) {
  if constexpr (std::is_same_v<Number, float>)
    put(out, std::bit_cast<std::uint32_t>(value));
  else
    put(out, static_cast<std::uint64_t>(value), sizeof value);
}

/// Appends the uint32 length of `text`, then `text`.
inline void put_text(std::string& out, std::string_view text) {
  put(out, static_cast<std::uint32_t>(text.size()));
  out.append(text);
}

/// A reader of bytes from front to back. After the first read beyond the end, every read returns 0 or an empty text,
/// and ok() is false.
class ByteReader {
 public:
  explicit ByteReader(std::string_view bytes) : rest_(bytes) {}

  /// Reads the next integer or float.
  template <class Number>
  Number number() {
    if constexpr (std::is_same_v<Number, float>)
      return std::bit_cast<float>(number<std::uint32_t>());
    else
      return static_cast<Number>(number(sizeof(Number)));
  }

  /// Reads the next `size` bytes as an integer; if `size` is above eight, only the first eight count.
  std::uint64_t number(std::size_t size) {
    std::uint64_t value = 0;
    const std::string_view bytes = take(size);
    for (std::size_t i = 0; i < bytes.size() && i < sizeof value; ++i)
      value |= std::uint64_t{static_cast<std::uint8_t>(bytes[i])} << (8 * i);
    return value;
  }

  /// Reads a uint32 length and then a text of that length.
  std::string_view text() { return take(number<std::uint32_t>()); }

  std::string_view take(std::size_t size) {
    if (!ok_ || size > rest_.size()) {
      ok_ = false;
      rest_ = {};
      return {};
    }
    const std::string_view taken = rest_.substr(0, size);
    rest_.remove_prefix(size);
    return taken;
  }

  std::string_view rest() const { return rest_; }
  bool ok() const { return ok_; }
  /// Returns true if every byte was read and no read went beyond the end.
  bool finished() const { return ok_ && rest_.empty(); }

 private:
  std::string_view rest_;
  bool ok_ = true;
};

}  // namespace robot
