#include "robot/nao/lola/message_pack.h"

#include <bit>
#include <cassert>

#include "robot/nao/lola/markers.h"

namespace robot::nao {
namespace {

constexpr int kMaxDepth = 8;
constexpr std::uint64_t kMaxBytes = 65535;

std::uint64_t read_big_endian(std::string_view bytes, std::size_t at, std::size_t size) {
  std::uint64_t value = 0;
  for (std::size_t i = 0; i < size; ++i) value = value << 8 | static_cast<std::uint8_t>(bytes[at + i]);
  return value;
}

/// Returns the lowest `bytes` bytes of `value` as a signed number.
std::int64_t with_sign(std::uint64_t value, std::size_t bytes) {
  const std::size_t unused = 64 - 8 * bytes;
  return static_cast<std::int64_t>(value << unused) >> unused;
}

}  // namespace

float read_other_number(std::string_view bytes, NumberSlot slot) {
  using enum NumberSlot::Kind;
  if (slot.kind == in_marker) return static_cast<float>(static_cast<std::int8_t>(bytes[slot.offset]));
  const std::uint64_t value = read_big_endian(bytes, slot.offset + 1u, slot.bytes);
  if (slot.kind == counting) return static_cast<float>(value);
  if (slot.kind == whole) return static_cast<float>(with_sign(value, slot.bytes));
  return static_cast<float>(std::bit_cast<double>(value));
}

MessagePackReader::MessagePackReader(std::string_view bytes) : bytes_(bytes) { assert(bytes.size() <= kMaxBytes); }

void MessagePackReader::fail(State state) {
  if (state_ == State::good) state_ = state;
}

std::uint64_t MessagePackReader::big_endian(std::size_t bytes) {
  const std::string_view taken = take(bytes);
  return read_big_endian(taken, 0, taken.size());
}

std::string_view MessagePackReader::take(std::uint64_t bytes) {
  if (bytes > bytes_.size() - at_) fail(bytes > kMaxBytes ? State::wrong : State::truncated);
  if (state_ != State::good) return {};
  const std::string_view taken = bytes_.substr(at_, static_cast<std::size_t>(bytes));
  at_ += taken.size();
  return taken;
}

std::uint8_t MessagePackReader::marker() { return static_cast<std::uint8_t>(big_endian(1)); }

/// Reads the count of a map or an array. It is in the lowest bits of `fix`, or in two or four bytes after `sixteen` or
/// the next marker.
std::uint32_t MessagePackReader::count(std::uint8_t fix, std::uint8_t fix_bits, std::uint8_t sixteen) {
  const std::uint8_t found = marker();
  if (state_ != State::good) return 0;
  if ((found & ~fix_bits) == fix) return found & fix_bits;
  if (found != sixteen && found != sixteen + 1) fail(State::wrong);
  const auto number = static_cast<std::uint32_t>(big_endian(found == sixteen ? 2 : 4));
  return state_ == State::good ? number : 0;
}

std::uint32_t MessagePackReader::map() { return count(kFixMap, 0x0f, kMap16); }
std::uint32_t MessagePackReader::array() { return count(kFixArray, 0x0f, kArray16); }

std::string_view MessagePackReader::text() {
  const std::uint8_t found = marker();
  if (state_ != State::good) return {};
  if ((found & 0xe0) == kFixText) return take(found & 0x1f);
  if (found < kText8 || found > kText8 + 2) {
    fail(State::wrong);
    return {};
  }
  return take(big_endian(std::size_t{1} << (found - kText8)));
}

NumberSlot MessagePackReader::number() {
  using enum NumberSlot::Kind;
  NumberSlot slot{.offset = static_cast<std::uint16_t>(at_)};
  const std::uint8_t found = marker();
  if (state_ != State::good) return {};
  if (found < kFixMap || found >= kNegative) return slot;
  if (found == kFloat32 || found == kFloat64) {
    slot.kind = floating;
    slot.bytes = found == kFloat32 ? 4 : 8;
  } else if (found >= kCounting8 && found < kWhole8 + 4) {
    slot.kind = found < kWhole8 ? counting : whole;
    slot.bytes = static_cast<std::uint8_t>(1 << (found & 3));
  } else {
    fail(State::wrong);
  }
  take(slot.bytes);
  return state_ == State::good ? slot : NumberSlot{};
}

void MessagePackReader::skip(int depth) {
  const std::uint8_t found = marker();
  if (state_ != State::good || found < kFixMap || found >= kNegative) return;
  std::uint64_t children = 0;
  if (found < kFixArray) {
    children = 2u * (found & 0x0f);
  } else if (found < kFixText) {
    children = found & 0x0f;
  } else if (found < kNil) {
    take(found & 0x1f);
  } else if (found == kNil || found == kFalse || found == kTrue) {
    return;
  } else if (found >= kBinary8 && found < kBinary8 + 3) {
    take(big_endian(std::size_t{1} << (found - kBinary8)));
  } else if (found >= kExtension8 && found < kExtension8 + 3) {
    // after the length comes a type of one byte
    take(big_endian(std::size_t{1} << (found - kExtension8)) + 1);
  } else if (found == kFloat32 || found == kFloat64) {
    take(found == kFloat32 ? 4 : 8);
  } else if (found >= kCounting8 && found < kFixExtension1) {
    take(std::uint64_t{1} << (found & 3));
  } else if (found >= kFixExtension1 && found < kText8) {
    take((std::uint64_t{1} << (found - kFixExtension1)) + 1);
  } else if (found >= kText8 && found < kArray16) {
    take(big_endian(std::size_t{1} << (found - kText8)));
  } else if (found >= kArray16) {
    const bool is_map = found >= kMap16;
    const std::uint64_t entries = big_endian(found % 2 == 0 ? 2 : 4);
    children = is_map ? 2 * entries : entries;
  } else {
    fail(State::wrong);
  }
  if (children > 0 && depth == kMaxDepth) fail(State::wrong);
  for (std::uint64_t i = 0; i < children && state_ == State::good; ++i) skip(depth + 1);
}

}  // namespace robot::nao
