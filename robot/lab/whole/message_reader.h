// A reader of single values in messages whose type is known from their schema alone.
#pragma once

#include <memory>
#include <string>
#include <string_view>

#include "robot/core/result.h"
#include "robot/lab/whole/field_path.h"
#include "robot/memory/channel.h"

namespace robot::lab {

/// The decoder of one channel with protobuf or JSON messages. It decodes like the viewer: a field of proto3 without
/// presence has its default, and a JSON value that is no object is the field "value". Used by one thread.
class MessageReader {
 public:
  /// Returns an Error for other encodings and for a schema that does not describe its message.
  static Result<std::unique_ptr<MessageReader>> open(const memory::ChannelInfo& info);

  virtual ~MessageReader() = default;

  /// Decodes a message for the next calls of number() and word(). Returns false if it does not fit the schema.
  virtual bool read(std::string_view bytes) = 0;

  /// Returns the number at `path`, or NaN if there is none. True is 1; an enum value is its number.
  virtual double number(const FieldPath& path) const = 0;

  /// Returns the value at `path` in words: a text, the name of an enum value, or a number. Empty if there is none.
  virtual std::string word(const FieldPath& path) const = 0;
};

}  // namespace robot::lab
