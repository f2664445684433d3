#include "robot/lab/mapping/mapping.h"

#include <google/protobuf/descriptor.h>

#include <algorithm>
#include <initializer_list>
#include <map>

#include "robot/core/clock.h"
#include "robot/core/files.h"
#include "robot/core/json.h"
#include "robot/core/json_library.h"
#include "robot/memory/memory.h"

namespace robot::lab {
namespace {

using google::protobuf::Descriptor;
using google::protobuf::DescriptorPool;
using google::protobuf::FieldDescriptor;
using Json = nlohmann::json;

constexpr std::size_t kMostFileBytes = 1 << 20;

/// Returns the place `name` in the object at `where`.
std::string below(const std::string& where, std::string_view name) {
  std::string place = where;
  place += '.';
  place += name;
  return place;
}

/// The reader of a mapping file. It keeps the first problem.
class MappingReader {
 public:
  explicit MappingReader(std::string name) : name_(std::move(name)) {}

  Result<Mapping> read(const Json& json) {
    Mapping mapping{.name = name_, .robot = "", .topics = {}};
    if (!is_object(json, "$", {"robot", "topics"})) return Error{problem_};
    mapping.robot = text(json, "$", "robot");
    if (problem_.empty() && !is_robot(mapping.robot))
      refuse("$.robot", "<team>/<player> such as \"14/2\"", json["robot"]);
    const Json topics = json.value("topics", Json());
    if (!topics.is_object() || topics.empty()) refuse("$.topics", "an object of topics", topics);
    if (!problem_.empty()) return Error{problem_};
    const auto objects = our_objects(mapping.robot);
    for (const auto& [topic, entries] : topics.items())
      for (const Json& entry : entries.is_array() ? entries : Json::array({entries}))
        mapping.topics.push_back(read_topic(topic, entry, objects));
    if (!problem_.empty()) return Error{problem_};
    return mapping;
  }

 private:
  using Objects = std::map<std::string, memory::ChannelInfo>;  // by name

  /// Returns all objects of a robot's memory: "ball", "/truth/world".
  static Objects our_objects(const std::string& robot) {
    Objects objects;
    const ManualClock clock;
    memory::Memory memory(robot, clock);
    memory.visit([&](const char* name, auto& object, memory::Delivery) { objects[name] = object.info(); });
    return objects;
  }

  static bool is_robot(const std::string& text) {
    const std::size_t slash = text.find('/');
    const auto number = [](std::string_view digits) {
      return !digits.empty() && digits.size() <= 3 &&
             std::ranges::all_of(digits, [](char c) { return c >= '0' && c <= '9'; });
    };
    return slash != std::string::npos && number(text.substr(0, slash)) && number(text.substr(slash + 1));
  }

  void refuse(const std::string& where, const std::string& expected, const Json& got) {
    if (problem_.empty())
      problem_ = name_ + ": " + where + ": expected " + expected + ", got " + (got.is_null() ? "nothing" : shown(got));
  }

  bool is_object(const Json& json, const std::string& where, std::initializer_list<std::string_view> keys) {
    std::string list;
    for (const std::string_view key : keys) list += (list.empty() ? "" : ", ") + std::string(key);
    if (!json.is_object()) {
      refuse(where, "an object with " + list, json);
      return false;
    }
    for (const auto& [key, value] : json.items())
      if (std::ranges::find(keys, key) == keys.end()) refuse(where, list, Json("the unknown key " + key));
    return problem_.empty();
  }

  std::string text(const Json& object, const std::string& where, const char* key) {
    const Json value = object.value(key, Json());
    if (value.is_string() && !value.get_ref<const std::string&>().empty()) return value.get<std::string>();
    refuse(below(where, key), "a text", value);
    return {};
  }

  TopicRule read_topic(const std::string& topic, const Json& json, const Objects& objects) {
    const std::string where = "$.topics[\"" + topic + "\"]";
    TopicRule rule{.from = topic, .info = {}, .message = nullptr, .fields = {}};
    if (!is_object(json, where, {"object", "fields"})) return rule;
    const std::string object = text(json, where, "object");
    const auto found = objects.find(object);
    if (found == objects.end()) {
      std::string names;
      for (const auto& [name, info] : objects) names += (names.empty() ? "" : ", ") + name;
      refuse(where + ".object", "one of " + names, json.value("object", Json()));
      return rule;
    }
    rule.info = found->second;
    rule.message = DescriptorPool::generated_pool()->FindMessageTypeByName(rule.info.schema.name);
    rule.fields = read_fields(json.value("fields", Json()), where + ".fields", *rule.message);
    return rule;
  }

  std::vector<FieldRule> read_fields(const Json& json, const std::string& where, const Descriptor& message) {
    std::vector<FieldRule> rules;
    if (!json.is_object() || json.empty()) {
      refuse(where, "an object of fields of " + message.full_name(), json);
      return rules;
    }
    for (const auto& [name, entry] : json.items()) {
      const FieldDescriptor* const field = message.FindFieldByName(name);
      if (field)
        rules.push_back(read_field(entry, below(where, name), *field));
      else
        refuse(where, "fields of " + message.full_name() + " (" + fields_of(message) + ")", Json(name));
    }
    return rules;
  }

  static std::string fields_of(const Descriptor& message) {
    std::string names;
    for (int i = 0; i < message.field_count(); ++i) names += (i == 0 ? "" : ", ") + message.field(i)->name();
    return names;
  }

  FieldRule read_field(const Json& json, const std::string& where, const FieldDescriptor& field) {
    FieldRule rule{.field = &field, .from = "", .value = {}, .names = {}, .fields = {}};
    if (field.message_type()) {
      const char* const key = field.is_repeated() ? "each" : "from";
      if (!is_object(json, where, {key, "fields"})) return rule;
      // without "from", the paths of its fields start at the enclosing message
      rule.from = field.is_repeated() || json.contains(key) ? text(json, where, key) : std::string();
      rule.fields = read_fields(json.value("fields", Json()), where + ".fields", *field.message_type());
    } else if (json.is_string()) {
      rule.from = json.get<std::string>();
      if (rule.from.empty()) refuse(where, "a path", json);
    } else if (json.is_object() && json.contains("value")) {
      if (is_object(json, where, {"value"})) rule.value = json["value"];
    } else if (is_object(json, where, {"from", "scale", "add", "names"})) {
      rule.from = text(json, where, "from");
      rule.scale = number(json, where, "scale", 1);
      rule.add = number(json, where, "add", 0);
      rule.names = json.value("names", Json());
      if (!rule.names.is_null()) check_names(rule.names, where + ".names", field);
    }
    return rule;
  }

  double number(const Json& object, const std::string& where, const char* key, double otherwise) {
    const Json value = object.value(key, Json(otherwise));
    if (value.is_number()) return value.get<double>();
    refuse(below(where, key), "a number", value);
    return otherwise;
  }

  void check_names(const Json& names, const std::string& where, const FieldDescriptor& field) {
    if (!names.is_object() || !field.enum_type())
      return refuse(where, field.enum_type() ? "an object of texts" : "nothing: " + field.name() + " has no names",
                    names);
    for (const auto& [theirs, ours] : names.items())
      if (!ours.is_string() || !field.enum_type()->FindValueByName(ours.get<std::string>()))
        refuse(below(where, theirs), "a value of " + field.enum_type()->full_name(), ours);
  }

  const std::string name_;
  std::string problem_;
};

}  // namespace

Result<Mapping> parse_mapping(const std::string& name, std::string_view text) {
  const Result<Json> json = parse_json(text);
  if (!json) return json.failure(name);
  return MappingReader(name).read(*json);
}

Result<Mapping> read_mapping(const std::filesystem::path& file) {
  const Result<std::string> text = read_file(file, kMostFileBytes);
  if (!text) return text.failure();
  return parse_mapping(file.string(), *text);
}

}  // namespace robot::lab
