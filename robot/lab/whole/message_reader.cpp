#include "robot/lab/whole/message_reader.h"

#include <google/protobuf/descriptor.h>
#include <google/protobuf/dynamic_message.h>
#include <google/protobuf/message.h>

#include <cmath>
#include <limits>
#include <optional>
#include <utility>

#include "robot/core/json.h"
#include "robot/core/json_library.h"
#include "robot/memory/schema_pool.h"

namespace robot::lab {
namespace {

using google::protobuf::FieldDescriptor;
using google::protobuf::Message;
using google::protobuf::Reflection;
using Json = nlohmann::json;

constexpr double kNone = std::numeric_limits<double>::quiet_NaN();

/// Returns a number in few letters: 3, 0.25.
std::string in_words(double number) { return std::isnan(number) ? "" : Json(number).dump(); }

/// A value in a message: the message itself, one of its fields, or an element of a list in it.
struct Place {
  const Message* message = nullptr;
  const FieldDescriptor* field = nullptr;  // null: the message itself
  int index = -1;                          // in the list; -1: the whole field

  bool is_list() const { return field && field->is_repeated() && index < 0; }

  /// Returns the message at this place, or null for a scalar, a list and an absent message.
  const Message* inner() const {
    if (!field) return message;
    if (field->cpp_type() != FieldDescriptor::CPPTYPE_MESSAGE || is_list()) return nullptr;
    const Reflection& reflection = *message->GetReflection();
    if (index >= 0) return &reflection.GetRepeatedMessage(*message, field, index);
    return reflection.HasField(*message, field) ? &reflection.GetMessage(*message, field) : nullptr;
  }

  int size() const { return message->GetReflection()->FieldSize(*message, field); }
};

bool is_absent(const Place& at) {
  return !at.field || at.is_list() ||
         (!at.field->is_repeated() && at.field->has_presence() &&
          !at.message->GetReflection()->HasField(*at.message, at.field));
}

double number_at(const Place& at) {
  if (is_absent(at)) return kNone;
  const Reflection& get = *at.message->GetReflection();
  const auto read = [&]<class T>(T (Reflection::*one)(const Message&, const FieldDescriptor*) const,
                                 T (Reflection::*element)(const Message&, const FieldDescriptor*, int) const) {
    return static_cast<double>(at.index < 0 ? (get.*one)(*at.message, at.field)
                                            : (get.*element)(*at.message, at.field, at.index));
  };
  switch (at.field->cpp_type()) {
    case FieldDescriptor::CPPTYPE_INT32: return read(&Reflection::GetInt32, &Reflection::GetRepeatedInt32);
    case FieldDescriptor::CPPTYPE_INT64: return read(&Reflection::GetInt64, &Reflection::GetRepeatedInt64);
    case FieldDescriptor::CPPTYPE_UINT32: return read(&Reflection::GetUInt32, &Reflection::GetRepeatedUInt32);
    case FieldDescriptor::CPPTYPE_UINT64: return read(&Reflection::GetUInt64, &Reflection::GetRepeatedUInt64);
    case FieldDescriptor::CPPTYPE_FLOAT: return read(&Reflection::GetFloat, &Reflection::GetRepeatedFloat);
    case FieldDescriptor::CPPTYPE_DOUBLE: return read(&Reflection::GetDouble, &Reflection::GetRepeatedDouble);
    case FieldDescriptor::CPPTYPE_BOOL: return read(&Reflection::GetBool, &Reflection::GetRepeatedBool);
    case FieldDescriptor::CPPTYPE_ENUM: return read(&Reflection::GetEnumValue, &Reflection::GetRepeatedEnumValue);
    case FieldDescriptor::CPPTYPE_STRING:
    case FieldDescriptor::CPPTYPE_MESSAGE: return kNone;
  }
  return kNone;
}

std::string word_at(const Place& at) {
  if (is_absent(at)) return "";
  const Reflection& get = *at.message->GetReflection();
  if (at.field->type() == FieldDescriptor::TYPE_STRING)
    return at.index < 0 ? get.GetString(*at.message, at.field) : get.GetRepeatedString(*at.message, at.field, at.index);
  if (at.field->type() == FieldDescriptor::TYPE_ENUM)
    if (const auto* value = at.field->enum_type()->FindValueByNumber(static_cast<int>(number_at(at))))
      return value->name();
  return in_words(number_at(at));
}

std::optional<Place> field_of(const Message& message, const std::string& name) {
  const FieldDescriptor* const field = message.GetDescriptor()->FindFieldByName(name);
  return field ? std::optional(Place{.message = &message, .field = field}) : std::nullopt;
}

/// Returns the value of a key of a map.
std::optional<Place> entry_of(const Place& map, const std::string& key) {
  for (int i = 0; i < map.size(); ++i) {
    const Message& entry = *Place{map.message, map.field, i}.inner();
    if (word_at(*field_of(entry, "key")) == key) return field_of(entry, "value");
  }
  return std::nullopt;
}

std::optional<Place> stepped(const Place& at, const FieldStep& step) {
  if (const auto* name = std::get_if<std::string>(&step)) {
    if (at.is_list()) return at.field->is_map() ? entry_of(at, *name) : std::nullopt;
    const Message* const inner = at.inner();
    return inner ? field_of(*inner, *name) : std::nullopt;
  }
  if (!at.is_list() || at.field->is_map()) return std::nullopt;
  if (const auto* index = std::get_if<std::size_t>(&step)) {
    if (*index >= static_cast<std::size_t>(at.size())) return std::nullopt;
    return Place{at.message, at.field, static_cast<int>(*index)};
  }
  for (int i = 0; i < at.size(); ++i) {
    const Place element{at.message, at.field, i};
    const Message* const inner = element.inner();
    if (!inner) return std::nullopt;
    bool fits = true;
    for (const auto& [name, wanted] : std::get<EntryFilter>(step)) {
      const auto field = field_of(*inner, name);
      fits = fits && field && number_at(*field) == wanted;
    }
    if (fits) return element;
  }
  return std::nullopt;
}

class ProtobufReader final : public MessageReader {
 public:
  Result<void> learn(const memory::ChannelInfo& info) {
    const auto type = pool_.read(info.schema);
    if (!type) return type.failure(info.topic);
    message_.reset(factory_.GetPrototype(*type)->New());
    return {};
  }

  bool read(std::string_view bytes) override {
    return message_->ParseFromArray(bytes.data(), static_cast<int>(bytes.size()));
  }
  double number(const FieldPath& path) const override {
    const auto at = find(path);
    return at ? number_at(*at) : kNone;
  }
  std::string word(const FieldPath& path) const override {
    const auto at = find(path);
    return at ? word_at(*at) : "";
  }

 private:
  std::optional<Place> find(const FieldPath& path) const {
    std::optional<Place> at = Place{.message = message_.get()};
    for (const FieldStep& step : path)
      if (at) at = stepped(*at, step);
    return at;
  }

  memory::SchemaPool pool_;
  google::protobuf::DynamicMessageFactory factory_;
  std::unique_ptr<Message> message_;
};

double number_of(const Json& json) {
  if (json.is_boolean()) return json.get<bool>() ? 1 : 0;
  return json.is_number() ? json.get<double>() : kNone;
}

const Json* stepped(const Json& at, const FieldStep& step) {
  if (const auto* name = std::get_if<std::string>(&step)) {
    const auto found = at.is_object() ? at.find(*name) : at.end();
    return found == at.end() ? nullptr : &*found;
  }
  if (!at.is_array()) return nullptr;
  if (const auto* index = std::get_if<std::size_t>(&step)) return *index < at.size() ? &at[*index] : nullptr;
  for (const Json& element : at) {
    bool fits = true;
    for (const auto& [name, wanted] : std::get<EntryFilter>(step)) {
      const Json* const field = stepped(element, FieldStep(name));
      fits = fits && field && number_of(*field) == wanted;
    }
    if (fits) return &element;
  }
  return nullptr;
}

class JsonReader final : public MessageReader {
 public:
  bool read(std::string_view bytes) override {
    auto parsed = parse_json(bytes);
    if (!parsed) return false;
    message_ = parsed->is_object() ? std::move(*parsed) : Json{{"value", std::move(*parsed)}};
    return true;
  }
  double number(const FieldPath& path) const override {
    const Json* const at = find(path);
    return at ? number_of(*at) : kNone;
  }
  std::string word(const FieldPath& path) const override {
    const Json* const at = find(path);
    if (!at) return "";
    return at->is_string() ? at->get<std::string>() : in_words(number_of(*at));
  }

 private:
  const Json* find(const FieldPath& path) const {
    const Json* at = &message_;
    for (const FieldStep& step : path)
      if (at) at = stepped(*at, step);
    return at;
  }

  Json message_;
};

}  // namespace

Result<std::unique_ptr<MessageReader>> MessageReader::open(const memory::ChannelInfo& info) {
  if (info.message_encoding == "json") return std::unique_ptr<MessageReader>(std::make_unique<JsonReader>());
  if (info.message_encoding != "protobuf" || info.schema.encoding != "protobuf")
    return Error{info.topic + ": expected protobuf or JSON, got '" + info.message_encoding + "'"};
  auto reader = std::make_unique<ProtobufReader>();
  if (const Result<void> learned = reader->learn(info); !learned) return learned.failure();
  return std::unique_ptr<MessageReader>(std::move(reader));
}

}  // namespace robot::lab
