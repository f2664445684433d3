#include "robot/truth/calibration/json_reader.h"

#include <algorithm>

#include "robot/core/json.h"
#include "robot/core/json_library.h"
#include "robot/core/text.h"

namespace robot::truth {
namespace {

using Json = nlohmann::json;

const Json kNothing, kEmptyObject = Json::object(), kEmptyList = Json::array();
constexpr std::size_t kMostBytes = 200;

}  // namespace

void JsonReader::refuse(const std::string& problem) {
  if (good()) problem_ = problem;
}

const Json& JsonReader::member(const Json& object, const char* key) {
  const auto found = object.is_object() ? object.find(key) : object.end();
  if (found != object.end()) return *found;
  refuse(formatted("'%s' is missing", key));
  return kNothing;
}

double JsonReader::number(const Json& object, const char* key, double least, double most) {
  const Json& value = member(object, key);
  const double number = value.is_number() ? value.get<double>() : 0;
  if (value.is_number() && least <= number && number <= most) return number;
  refuse(formatted("'%s' must be a number %g .. %g, got %s", key, least, most, shown(value).c_str()));
  return least;
}

int JsonReader::whole(const Json& object, const char* key, int least, int most) {
  const Json& value = member(object, key);
  const auto number = whole_number(value);
  if (number && least <= *number && *number <= most) return static_cast<int>(*number);
  refuse(formatted("'%s' must be a whole number %d .. %d, got %s", key, least, most, shown(value).c_str()));
  return least;
}

bool JsonReader::truth(const Json& object, const char* key) {
  const Json& value = member(object, key);
  if (value.is_boolean()) return value.get<bool>();
  refuse(formatted("'%s' must be true or false, got %s", key, shown(value).c_str()));
  return false;
}

std::string JsonReader::text(const Json& object, const char* key) {
  const Json& value = member(object, key);
  if (value.is_string() && value.get_ref<const std::string&>().size() <= kMostBytes) return value.get<std::string>();
  refuse(formatted("'%s' must be a text of at most %zu bytes, got %s", key, kMostBytes, shown(value).c_str()));
  return {};
}

std::vector<double> JsonReader::numbers(const Json& object, const char* key, std::size_t count, double most) {
  const Json& values = member(object, key);
  const auto fits = [most](const Json& value) {
    return value.is_number() && -most <= value.get<double>() && value.get<double>() <= most;
  };
  if (values.is_array() && values.size() == count && std::all_of(values.begin(), values.end(), fits))
    return values.get<std::vector<double>>();
  refuse(
      formatted("'%s' must be a list of %zu numbers %g .. %g, got %s", key, count, -most, most, shown(values).c_str()));
  return std::vector<double>(count);
}

const Json& JsonReader::object(const Json& object, const char* key) {
  const Json& value = member(object, key);
  if (value.is_object()) return value;
  refuse(formatted("'%s' must be an object, got %s", key, shown(value).c_str()));
  return kEmptyObject;
}

const Json& JsonReader::list(const Json& object, const char* key, std::size_t most) {
  const Json& value = member(object, key);
  if (value.is_array() && value.size() <= most) return value;
  refuse(formatted("'%s' must be a list of at most %zu entries, got %s", key, most, shown(value).c_str()));
  return kEmptyList;
}

}  // namespace robot::truth
