// The bytes of MCAP records, written by hand: the generator shares no code with our writer.
#pragma once

#include <cstdint>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace tests {

/// A growing record or file. Integers are little endian.
class McapBytes {
 public:
  McapBytes& u8(unsigned value) { return number(value, 1); }
  McapBytes& u16(unsigned value) { return number(value, 2); }
  McapBytes& u32(std::uint64_t value) { return number(value, 4); }
  McapBytes& u64(std::uint64_t value) { return number(value, 8); }
  McapBytes& raw(std::string_view value) {
    bytes_ += value;
    return *this;
  }
  McapBytes& text(std::string_view value) { return u32(value.size()).raw(value); }
  McapBytes& texts(const std::vector<std::pair<std::string, std::string>>& values) {
    McapBytes inner;
    for (const auto& [key, value] : values) inner.text(key).text(value);
    return text(inner.bytes_);
  }

  /// Appends a whole record.
  McapBytes& record(unsigned op, const McapBytes& content) {
    return u8(op).u64(content.bytes_.size()).raw(content.bytes_);
  }

  const std::string& bytes() const { return bytes_; }
  std::uint64_t size() const { return bytes_.size(); }

 private:
  McapBytes& number(std::uint64_t value, int size) {
    for (int i = 0; i < size; ++i) bytes_.push_back(static_cast<char>(value >> (8 * i)));
    return *this;
  }

  std::string bytes_;
};

}  // namespace tests
