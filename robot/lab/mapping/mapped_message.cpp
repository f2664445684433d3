// The translation of one message of another program to ours.
#include <google/protobuf/descriptor.h>
#include <google/protobuf/dynamic_message.h>
#include <google/protobuf/message.h>
#include <google/protobuf/util/json_util.h>

#include <charconv>
#include <cmath>
#include <limits>

#include "robot/core/encoding.h"
#include "robot/core/json.h"
#include "robot/core/json_library.h"
#include "robot/lab/mapping/mapping.h"
#include "robot/memory/schema_pool.h"

namespace robot::lab {
namespace {

using google::protobuf::FieldDescriptor;
using google::protobuf::Message;
using google::protobuf::MessageFactory;
using Json = nlohmann::json;

constexpr std::string_view kTime = "@time";
constexpr int kChecked = 100;  // [messages]

/// Returns the value at `path` in `json`, or null if there is none.
const Json* at(const Json& json, std::string_view path) {
  const Json* place = &json;
  while (!path.empty()) {
    if (path.front() == '[') {
      const std::size_t end = path.find(']');
      std::size_t index = 0;
      const auto [stop, error] = std::from_chars(path.data() + 1, path.data() + path.size(), index);
      if (end == path.npos || error != std::errc() || stop != path.data() + end) return nullptr;
      if (!place->is_array() || index >= place->size()) return nullptr;
      place = &(*place)[index];
      path.remove_prefix(end + 1);
    } else {
      if (path.front() == '.') path.remove_prefix(1);
      const std::size_t end = std::min(path.find_first_of(".["), path.size());
      const auto found = place->is_object() ? place->find(std::string(path.substr(0, end))) : place->end();
      if (!place->is_object() || found == place->end()) return nullptr;
      place = &*found;
      path.remove_prefix(end);
    }
  }
  return place->is_null() ? nullptr : place;
}

/// Converts numbers, booleans (0 or 1), and the decimal texts that protobuf's JSON has for 64-bit numbers.
std::optional<double> as_number(const Json& json) {
  if (json.is_number()) return json.get<double>();
  if (json.is_boolean()) return json.get<bool>() ? 1 : 0;
  if (!json.is_string()) return std::nullopt;
  const auto& text = json.get_ref<const std::string&>();
  double value = 0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
  if (error != std::errc() || end != text.data() + text.size()) return std::nullopt;
  return value;
}

/// Converts a whole number without loss, or returns nothing if the value is not a whole number in the range of T.
template <class T>
std::optional<T> exactly(const Json& json) {
  if (json.is_number_unsigned() &&
      json.get<std::uint64_t>() <= static_cast<std::uint64_t>(std::numeric_limits<T>::max()))
    return static_cast<T>(json.get<std::uint64_t>());
  if (json.is_number_integer() && std::numeric_limits<T>::is_signed && json.get<std::int64_t>() < 0 &&
      json.get<std::int64_t>() >= static_cast<std::int64_t>(std::numeric_limits<T>::min()))
    return static_cast<T>(json.get<std::int64_t>());
  if (!json.is_string()) return std::nullopt;
  const auto& text = json.get_ref<const std::string&>();
  T value{};
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
  return error == std::errc() && end == text.data() + text.size() ? std::optional(value) : std::nullopt;
}

/// A writer of values into one message of ours.
class Writer {
 public:
  Writer(Message& message, std::uint64_t capture_ns, bool strict)
      : message_(message), reflection_(*message.GetReflection()), capture_ns_(capture_ns), strict_(strict) {}

  Result<void> put(const FieldRule& rule, const Json& theirs) {
    const Json time = rule.from == kTime ? Json(capture_ns_) : Json();
    const Json* const value = rule.from.empty() ? (rule.field->message_type() ? &theirs : &rule.value)
                              : !time.is_null() ? &time
                                                : at(theirs, rule.from);
    if (!value)
      return strict_
                 ? Result<void>(Error{"expected '" + rule.from + "' for " + rule.field->name() + ", it is not there"})
                 : Result<void>();
    if (!rule.field->is_repeated()) return put_one(rule, *value);
    if (!value->is_array()) return wrong(rule, *value, "a list");
    for (const Json& element : *value)
      if (Result<void> put = put_one(rule, element); !put) return put;
    return {};
  }

 private:
  static Error wrong(const FieldRule& rule, const Json& got, const std::string& expected) {
    return Error{"expected " + expected + " at '" + rule.from + "' for " + rule.field->name() + ", got " + shown(got)};
  }

  template <class T>
  void set(const FieldDescriptor& field, T value,
           void (google::protobuf::Reflection::*one)(Message*, const FieldDescriptor*, T) const,
           void (google::protobuf::Reflection::*more)(Message*, const FieldDescriptor*, T) const) {
    (reflection_.*(field.is_repeated() ? more : one))(&message_, &field, value);
  }

  template <class T>
  Result<void> put_whole(const FieldRule& rule, const Json& value,
                         void (google::protobuf::Reflection::*one)(Message*, const FieldDescriptor*, T) const,
                         void (google::protobuf::Reflection::*more)(Message*, const FieldDescriptor*, T) const) {
    if (rule.scale == 1 && rule.add == 0)
      if (const auto exact = exactly<T>(value)) return set(*rule.field, *exact, one, more), Result<void>();
    const auto number = as_number(value);
    const double result = number ? std::round(rule.scale * *number + rule.add) : std::nan("");
    constexpr auto kMost = static_cast<double>(std::numeric_limits<T>::max());
    if (!(result >= static_cast<double>(std::numeric_limits<T>::min()) && result < kMost))
      return wrong(rule, value, "a whole number");
    set(*rule.field, static_cast<T>(result), one, more);
    return {};
  }

  Result<void> put_enum(const FieldRule& rule, const Json& value) {
    const auto& type = *rule.field->enum_type();
    const std::string text = value.is_string() ? value.get<std::string>() : value.dump();
    const google::protobuf::EnumValueDescriptor* found = nullptr;
    if (!rule.names.is_null()) {
      const auto name = rule.names.find(text);
      found = name == rule.names.end() ? nullptr : type.FindValueByName(name->get<std::string>());
    } else {
      found = value.is_number_integer() ? type.FindValueByNumber(value.get<int>()) : type.FindValueByName(text);
    }
    if (!found) return wrong(rule, value, "a value of " + type.full_name());
    if (rule.field->is_repeated())
      reflection_.AddEnum(&message_, rule.field, found);
    else
      reflection_.SetEnum(&message_, rule.field, found);
    return {};
  }

  Result<void> put_bytes(const FieldRule& rule, const Json& value) {
    if (!value.is_string()) return wrong(rule, value, "a text");
    std::string bytes = value.get<std::string>();
    if (rule.field->type() == FieldDescriptor::TYPE_BYTES) {
      auto decoded = from_base64(bytes);
      if (!decoded) return wrong(rule, value, "bytes");
      bytes = std::move(*decoded);
    }
    if (rule.field->is_repeated())
      reflection_.AddString(&message_, rule.field, std::move(bytes));
    else
      reflection_.SetString(&message_, rule.field, std::move(bytes));
    return {};
  }

  Result<void> put_message(const FieldRule& rule, const Json& value) {
    Writer inner(rule.field->is_repeated() ? *reflection_.AddMessage(&message_, rule.field)
                                           : *reflection_.MutableMessage(&message_, rule.field),
                 capture_ns_, strict_);
    for (const FieldRule& field : rule.fields)
      if (Result<void> put = inner.put(field, value); !put) return put;
    return {};
  }

  Result<void> put_one(const FieldRule& rule, const Json& value) {
    using google::protobuf::Reflection;
    const FieldDescriptor& field = *rule.field;
    const auto number = as_number(value);
    const double scaled = number ? rule.scale * *number + rule.add : 0;
    switch (field.cpp_type()) {
      case FieldDescriptor::CPPTYPE_MESSAGE: return put_message(rule, value);
      case FieldDescriptor::CPPTYPE_ENUM: return put_enum(rule, value);
      case FieldDescriptor::CPPTYPE_STRING: return put_bytes(rule, value);
      case FieldDescriptor::CPPTYPE_INT32:
        return put_whole<std::int32_t>(rule, value, &Reflection::SetInt32, &Reflection::AddInt32);
      case FieldDescriptor::CPPTYPE_INT64:
        return put_whole<std::int64_t>(rule, value, &Reflection::SetInt64, &Reflection::AddInt64);
      case FieldDescriptor::CPPTYPE_UINT32:
        return put_whole<std::uint32_t>(rule, value, &Reflection::SetUInt32, &Reflection::AddUInt32);
      case FieldDescriptor::CPPTYPE_UINT64:
        return put_whole<std::uint64_t>(rule, value, &Reflection::SetUInt64, &Reflection::AddUInt64);
      case FieldDescriptor::CPPTYPE_BOOL:
        if (!number) return wrong(rule, value, "true or false");
        set(field, scaled != 0, &Reflection::SetBool, &Reflection::AddBool);
        return {};
      case FieldDescriptor::CPPTYPE_FLOAT:
        if (!number) return wrong(rule, value, "a number");
        set(field, static_cast<float>(scaled), &Reflection::SetFloat, &Reflection::AddFloat);
        return {};
      case FieldDescriptor::CPPTYPE_DOUBLE:
        if (!number) return wrong(rule, value, "a number");
        set(field, scaled, &Reflection::SetDouble, &Reflection::AddDouble);
        return {};
    }
    return {};
  }

  Message& message_;
  const google::protobuf::Reflection& reflection_;
  const std::uint64_t capture_ns_;
  const bool strict_;
};

}  // namespace

Result<std::string> mapped(const TopicRule& rule, const Json& theirs, std::uint64_t capture_ns, bool strict) {
  const std::unique_ptr<Message> message(MessageFactory::generated_factory()->GetPrototype(rule.message)->New());
  Writer writer(*message, capture_ns, strict);
  for (const FieldRule& field : rule.fields)
    if (Result<void> put = writer.put(field, theirs); !put) return put.failure(rule.from);
  return message->SerializeAsString();
}

/// The decoder of one channel of theirs.
class MappedInProvider::Reader {
 public:
  Result<void> open(const memory::ChannelInfo& info) {
    json_ = info.message_encoding == "json";
    if (json_) return {};
    if (info.message_encoding != "protobuf" || info.schema.encoding != "protobuf")
      return Error{info.topic + ": expected protobuf or JSON, got '" + info.message_encoding + "'"};
    const auto message = pool_.read(info.schema);
    if (!message) return message.failure(info.topic);
    prototype_ = factory_.GetPrototype(*message);
    return {};
  }

  Result<Json> read(const std::string& bytes) const {
    if (json_) return parse_json(bytes);
    const std::unique_ptr<Message> message(prototype_->New());
    if (!message->ParseFromString(bytes))
      return Error{"expected a " + prototype_->GetDescriptor()->full_name() + ", got " + std::to_string(bytes.size()) +
                   " bytes of something else"};
    google::protobuf::util::JsonPrintOptions options;
    options.preserve_proto_field_names = true;
    options.always_print_primitive_fields = true;
    std::string text;
    if (const auto printed = google::protobuf::util::MessageToJsonString(*message, &text, options); !printed.ok())
      return Error{"a message cannot be read: " + printed.ToString()};
    return parse_json(text);
  }

 private:
  bool json_ = false;
  memory::SchemaPool pool_;
  google::protobuf::DynamicMessageFactory factory_;
  const Message* prototype_ = nullptr;
};

MappedInProvider::MappedInProvider(std::unique_ptr<logging::InProvider> stream, TopicRule rule)
    : stream_(std::move(stream)), rule_(std::move(rule)), reader_(std::make_unique<Reader>()) {}

MappedInProvider::~MappedInProvider() = default;

Result<memory::ChannelInfo> MappedInProvider::open() {
  const Result<memory::ChannelInfo> info = stream_->open();
  if (!info) return info.failure();
  if (Result<void> opened = reader_->open(*info); !opened) return opened.failure();
  if (Result<void> fits = check_first(); !fits) return fits.failure();
  return rule_.info;
}

Result<std::string> MappedInProvider::translate(const logging::Record& record, bool strict) const {
  const auto theirs = reader_->read(record.bytes);
  if (!theirs) return theirs.failure(rule_.from);
  return mapped(rule_, *theirs, record.capture_ns, strict);
}

/// Reports a wrong mapping before anything is played. One fitting message is enough, because single messages may be
/// incomplete.
Result<void> MappedInProvider::check_first() {
  std::optional<std::string> problem;
  for (int i = 0; i < kChecked; ++i) {
    const auto record = stream_->read();
    if (!record) continue;
    if (!*record) break;
    const auto ours = translate(**record, /*strict=*/true);
    if (ours) return stream_->seek(0);
    if (!problem) problem = ours.error();
  }
  if (problem) return Error{*problem};
  return stream_->seek(0);
}

Result<std::optional<logging::Record>> MappedInProvider::read() {
  while (true) {
    auto record = stream_->read();
    if (!record || !*record) return record;
    auto ours = translate(**record, /*strict=*/false);
    if (ours) {
      (*record)->bytes = std::move(*ours);
      return record;
    }
    if (lost_.fetch_add(1, std::memory_order_relaxed) == 0) return ours.failure();
  }
}

}  // namespace robot::lab
