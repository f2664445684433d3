#include "sim/io/reader.h"

#include <algorithm>
#include <cmath>

#include "robot/core/json_library.h"
#include "sim/io/source.h"
#include "sim/io/words.h"

namespace sim::io {
namespace {

std::string in_unit(std::string_view unit) { return unit.empty() ? "" : " [" + std::string(unit) + "]"; }

}  // namespace

std::string Reader::below(const std::string& path, std::string_view name) {
  return path.empty() ? std::string(name) : path + "." + std::string(name);
}

bool Reader::is_object(const Json& json, const std::string& path) {
  if (!json.is_object()) refuse((path.empty() ? "the description" : path) + " must be an object, got " + shown(json));
  return json.is_object();
}

const Json* Reader::find(const Json& parent, const char* name, Fields fields) {
  const auto found = parent.find(name);
  if (found != parent.end()) return &*found;
  if (fields == Fields::all) refuse(std::string(name) + " is missing");
  return nullptr;
}

std::string Reader::text(const Json& object, const std::string& path, const char* name, std::string otherwise) {
  const auto found = object.find(name);
  if (found == object.end()) return otherwise;
  if (found->is_string()) return found->get<std::string>();
  refuse(below(path, name) + " must be a text, got " + shown(*found));
  return otherwise;
}

void Reader::refuse_unknown(const Json& object, const std::string& path, const std::vector<std::string_view>& known) {
  for (const auto& [key, value] : object.items()) {
    if (std::find(known.begin(), known.end(), key) != known.end()) continue;
    const std::string similar = did_you_mean(key, known);
    refuse(below(path, key) + " is unknown" + (similar.empty() ? "; there are: " + listed(known) : similar));
  }
}

std::string Reader::range(float least, float most, std::string_view unit) {
  return short_text(least) + " .. " + short_text(most) + in_unit(unit);
}

std::string Reader::range(int least, int most, std::string_view unit) {
  return std::to_string(least) + " .. " + std::to_string(most) + in_unit(unit);
}

std::string Reader::range(bool, bool, std::string_view) { return "true or false"; }

const Json* Reader::value_of(const Json& entry, const std::string& path, std::string_view unit) {
  // the source of the old value does not hold for the new one
  if (sources_) sources_->erase(path);
  if (!entry.is_object()) return &entry;
  refuse_unknown(entry, path, {"value", "unit", "source"});
  const auto value = entry.find("value");
  if (value == entry.end()) {
    refuse(path + " has no value");
    return nullptr;
  }
  const auto given = entry.find("unit");
  if (given != entry.end() ? *given != unit : !unit.empty())
    refuse(path + " must have the unit '" + std::string(unit) + "', got " +
           (given != entry.end() ? shown(*given) : "none"));
  if (const auto source = entry.find("source"); source != entry.end() && !source->is_string())
    refuse(path + ".source must be a text, got " + shown(*source));
  else if (sources_ && source != entry.end())
    (*sources_)[path] = source->get<std::string>();
  return &*value;
}

void Reader::read_value(const Json& entry, const std::string& path, const char* unit, float least, float most,
                        float& into) {
  const Json* value = value_of(entry, path, unit);
  if (!value) return;
  // compared as float, because 0.7 as double exceeds the float 0.7
  const double exact = value->is_number() ? value->get<double>() : 0;
  const float number = std::abs(exact) < 1e30 ? static_cast<float>(exact) : 1e30f;
  if (!value->is_number() || !(number >= least && number <= most))
    return refuse(path + " must be " + range(least, most, unit) + ", got " + shown(*value));
  into = number;
}

void Reader::read_value(const Json& entry, const std::string& path, const char* unit, int least, int most, int& into) {
  const Json* value = value_of(entry, path, unit);
  if (!value) return;
  // the parser takes a number beyond 64 bits as not an integer
  const bool whole = value->is_number_integer();
  const std::int64_t number = whole ? value->get<std::int64_t>() : 0;
  if (!whole || number < least || number > most)
    return refuse(path + " must be a whole number, " + range(least, most, unit) + ", got " + shown(*value));
  into = static_cast<int>(number);
}

void Reader::read_value(const Json& entry, const std::string& path, const char* unit, bool least, bool most,
                        bool& into) {
  const Json* value = value_of(entry, path, unit);
  if (!value) return;
  if (!value->is_boolean()) return refuse(path + " must be " + range(least, most, unit) + ", got " + shown(*value));
  into = value->get<bool>();
}

namespace {

Json entry(Json value, std::string_view unit, std::string_view source) {
  if (unit.empty() && source.empty()) return value;
  Json object = {{"value", std::move(value)}, {"unit", unit}};
  if (!source.empty()) object["source"] = source;
  return object;
}

}  // namespace

Json entry_of(float value, std::string_view unit, std::string_view source) {
  return entry(short_number(value), unit, source);
}

Json entry_of(int value, std::string_view unit, std::string_view source) { return entry(value, unit, source); }

Json entry_of(bool value, std::string_view, std::string_view source) { return entry(value, "", source); }

}  // namespace sim::io
