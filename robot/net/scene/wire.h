// A writer of protobuf messages without generated classes, which would be large.
#pragma once

#include <cstdint>
#include <span>
#include <string>
#include <string_view>

namespace robot::net {

/// A message that is being written, field after field. `field` is the field's number in the .proto. Values that are the
/// default of proto3 are written too, so that readers without defaults see them.
class Wire {
 public:
  Wire& number(int field, double value);                     // double
  Wire& numbers(int field, std::span<const double> values);  // repeated double
  Wire& integer(int field, std::uint64_t value);             // bool, enum, int32, int64 of a value that is not negative
  Wire& fixed(int field, std::uint32_t value);               // fixed32
  Wire& text(int field, std::string_view value);             // string, bytes
  Wire& message(int field, const Wire& value) { return text(field, value.bytes_); }

  const std::string& bytes() const { return bytes_; }

 private:
  void varint(std::uint64_t value);
  void tag(int field, int type) { varint(static_cast<std::uint64_t>(field) << 3 | static_cast<std::uint64_t>(type)); }
  void little_endian(std::uint64_t value, int bytes);

  std::string bytes_;
};

/// Returns a google.protobuf.Timestamp.
Wire timestamp(std::uint64_t ns);

}  // namespace robot::net
