// The fields of an MCAP record to bytes and back. Part of format.cpp: one list of fields serves both directions.
#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>

#include "robot/core/little_endian.h"
#include "robot/logging/mcap/format.h"

namespace robot::logging::mcap {

/// A visitor of a record's fields that appends each of them to a string.
class Encoder {
 public:
  template <class Record>
  using Access = const Record;

  explicit Encoder(std::string& out) : out_(out) {}

  template <class Number>
  void number(const char*, Number value) {
    put(out_, value);
  }
  void op(const char*, Op value) { put(out_, static_cast<std::uint8_t>(value)); }
  void text(const char*, std::string_view value) { put_text(out_, value); }
  void long_bytes(const char*, std::string_view value) {
    put(out_, static_cast<std::uint64_t>(value.size()));
    out_.append(value);
  }
  void rest(const char*, std::string_view value) { out_.append(value); }
  void texts(const char*, const Texts& values) {
    const std::size_t begin = begin_sized();
    for (const auto& [key, value] : values) text("", key), text("", value);
    end_sized(begin);
  }
  template <class Key>
  void numbers(const char*, const Numbers<Key>& values) {
    const std::size_t begin = begin_sized();
    for (const auto& [key, value] : values) put(out_, key), put(out_, value);
    end_sized(begin);
  }

 private:
  /// Reserves a u32, to which end_sized() writes the number of bytes appended in between.
  std::size_t begin_sized() {
    put(out_, std::uint32_t{0});
    return out_.size();
  }
  void end_sized(std::size_t begin) {
    std::string size;
    put(size, static_cast<std::uint32_t>(out_.size() - begin));
    out_.replace(begin - size.size(), size.size(), size);
  }

  std::string& out_;
};

/// A visitor of the same fields that fills each of them from bytes. After the first wrong field it leaves the others
/// unchanged.
class Decoder {
 public:
  template <class Record>
  using Access = Record;

  explicit Decoder(std::string_view content) : left_(content) {}

  /// Returns a sentence about the first wrong field, or an empty string.
  const std::string& wrong() const { return wrong_; }

  template <class Number>
  void number(const char* field, Number& value) {
    if (const auto bytes = take(field, sizeof value); bytes.size() == sizeof value)
      value = ByteReader(bytes).number<Number>();
  }
  void op(const char* field, Op& value) {
    std::uint8_t number_of_op = 0;
    number(field, number_of_op);
    value = static_cast<Op>(number_of_op);
  }
  void text(const char* field, std::string& value) { value = sized<std::uint32_t>(field); }
  void long_bytes(const char* field, std::string_view& value) { value = sized<std::uint64_t>(field); }
  void rest(const char* field, std::string_view& value) { value = take(field, left_.size()); }
  void texts(const char* field, Texts& values) {
    Decoder inner(sized<std::uint32_t>(field));
    while (!inner.left_.empty() && inner.wrong_.empty()) {
      std::string key;
      inner.text(field, key);
      inner.text(field, values[key]);
    }
    if (wrong_.empty()) wrong_ = inner.wrong_;
  }
  template <class Key>
  void numbers(const char* field, Numbers<Key>& values) {
    constexpr std::size_t kEntryBytes = sizeof(Key) + sizeof(std::uint64_t);
    const std::string_view bytes = sized<std::uint32_t>(field);
    if (bytes.size() % kEntryBytes != 0)
      return fail(field, "entries of " + std::to_string(kEntryBytes) + " bytes", bytes.size());
    values.reserve(bytes.size() / kEntryBytes);
    for (ByteReader entries(bytes); !entries.finished();) {
      const auto key = entries.number<Key>();
      values.emplace_back(key, entries.number<std::uint64_t>());
    }
  }

 private:
  void fail(const char* field, const std::string& expected, std::uint64_t got) {
    if (wrong_.empty()) wrong_ = std::string(field) + ": expected " + expected + ", got " + std::to_string(got);
    left_ = {};
  }

  std::string_view take(const char* field, std::uint64_t size) {
    if (!wrong_.empty()) return {};
    if (size > left_.size()) {
      fail(field, std::to_string(size) + " bytes", left_.size());
      return {};
    }
    const std::string_view taken = left_.substr(0, static_cast<std::size_t>(size));
    left_.remove_prefix(taken.size());
    return taken;
  }

  template <class Size>
  std::string_view sized(const char* field) {
    Size size = 0;
    number(field, size);
    return take(field, size);
  }

  std::string_view left_;
  std::string wrong_;
};

}  // namespace robot::logging::mcap
