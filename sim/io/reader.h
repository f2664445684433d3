// Structs from JSON and back, by the list of fields in each struct: visit(self, see(name, value, unit, least, most)).
//
// An entry is a plain value, or {"value": …, "unit": "m/s", "source": "who measured it"}. A given unit
// must be the right one.
#pragma once

#include <initializer_list>
#include <map>
#include <string>
#include <string_view>
#include <vector>

#include "robot/core/json_library.h"
#include "sim/io/json.h"

namespace sim::io {

/// The fields that must be present: all, or only the changed ones.
enum class Fields { all, some };

/// The texts of "source", by the path of their entry: "walk.forward" → "HULKs 2025".
using Sources = std::map<std::string, std::string>;

/// A reader of one description. It keeps the first error.
class Reader {
 public:
  /// `called` opens the sentence of an error: "models 'match'". `sources` receives the source of each entry that is read.
  explicit Reader(std::string called, Sources* sources = nullptr) : called_(std::move(called)), sources_(sources) {}

  bool good() const { return problem_.empty(); }
  robot::Error error() const { return {called_ + ": " + problem_}; }
  /// Records an error, unless there is one already.
  void refuse(const std::string& problem) {
    if (good()) problem_ = problem;
  }

  /// Keeps the sources of a description that another reader has read for the entry at `path`.
  void add_sources(const std::string& path, const Sources& found) {
    if (sources_)
      for (const auto& [name, source] : found) (*sources_)[below(path, name)] = source;
  }

  /// Reads the fields of `into` from `object`, which is at `path` ("" is the top). Refuses keys that are neither fields
  /// nor among `others`.
  template <class Struct>
  void read(const Json& object, const std::string& path, Fields fields, Struct& into,
            std::initializer_list<std::string_view> others = {}) {
    if (!is_object(object, path)) return;
    std::vector<std::string_view> known(others);
    Struct::visit(into, [&](const char* name, auto& value, const char* unit, auto least, auto most) {
      known.push_back(name);
      read_entry(object, path, name, fields, unit, least, most, value);
    });
    refuse_unknown(object, path, known);
  }

  /// Returns the entry `name` of `parent`, or nullptr. A missing entry is an error if `fields` is all.
  const Json* find(const Json& parent, const char* name, Fields fields);

  /// Returns the text `name` of `object`, which is at `path` ("" is the top), or `otherwise` if there is no such entry.
  /// An entry that is no text is an error.
  std::string text(const Json& object, const std::string& path, const char* name, std::string otherwise = "");

  bool is_object(const Json& json, const std::string& path);
  void refuse_unknown(const Json& object, const std::string& path, const std::vector<std::string_view>& known);

  /// Joins "walk" and "forward" to "walk.forward".
  static std::string below(const std::string& path, std::string_view name);

 private:
  static std::string range(float least, float most, std::string_view unit);
  static std::string range(int least, int most, std::string_view unit);
  static std::string range(bool least, bool most, std::string_view unit);

  /// Reads the entry `name`, if there is one. Not inline: there are hundreds of fields.
  template <class Value>
  [[gnu::noinline]] void read_entry(const Json& object, const std::string& path, const char* name, Fields fields,
                                    const char* unit, Value least, Value most, Value& into) {
    if (const auto entry = object.find(name); entry != object.end())
      read_value(*entry, below(path, name), unit, least, most, into);
    else if (fields == Fields::all)
      refuse(below(path, name) + " is missing, expected " + range(least, most, unit));
  }

  /// Returns the value of an entry, or nullptr. Records its source.
  const Json* value_of(const Json& entry, const std::string& path, std::string_view unit);
  void read_value(const Json& entry, const std::string& path, const char* unit, float least, float most, float& into);
  void read_value(const Json& entry, const std::string& path, const char* unit, int least, int most, int& into);
  void read_value(const Json& entry, const std::string& path, const char* unit, bool least, bool most, bool& into);

  const std::string called_;
  Sources* const sources_;
  std::string problem_;
};

Json entry_of(float value, std::string_view unit, std::string_view source);
Json entry_of(int value, std::string_view unit, std::string_view source);
Json entry_of(bool value, std::string_view unit, std::string_view source);

/// Returns the object at `path` that `read` reads back, with its sources.
template <class Struct>
Json written(const Struct& from, const std::string& path, const Sources& sources) {
  Json object = Json::object();
  Struct::visit(from, [&](const char* name, const auto& value, const char* unit, auto, auto) {
    const auto source = sources.find(Reader::below(path, name));
    object[name] = entry_of(value, unit, source == sources.end() ? "" : source->second);
  });
  return object;
}

}  // namespace sim::io
