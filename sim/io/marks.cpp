#include "sim/io/marks.h"

#include <string>
#include <utility>

#include "robot/core/json_library.h"
#include "robot/core/text.h"
#include "sim/io/vocabulary.h"

namespace sim::io {
namespace {

using robot::Error;
using robot::Result;

constexpr const char* kLearn = "learn";

/// Removes marks. Keeps the first problem.
class Cleaner {
 public:
  const std::string& problem() const { return problem_; }

  Json clean(const Json& json, const std::string& place) {
    if (json.is_array()) return clean_list(json, place);
    if (!json.is_object()) return json;
    const auto mark = json.find(kLearn);
    if (mark != json.end()) check(json, *mark, place);
    // a marked number is its value; habits and roles write numbers as objects themselves
    if (mark != json.end() && json.contains("value") && !json.contains("unit")) return json["value"];
    Json cleaned = Json::object();
    for (const auto& [key, value] : json.items())
      if (key != kLearn)
        cleaned[key] = clean(value, place.empty() ? key : robot::formatted("%s.%s", place.c_str(), key.c_str()));
    return cleaned;
  }

 private:
  Json clean_list(const Json& json, const std::string& place) {
    Json cleaned = Json::array();
    for (std::size_t i = 0; i < json.size(); ++i)
      cleaned.push_back(clean(json[i], place + "[" + std::to_string(i) + "]"));
    return cleaned;
  }

  void refuse(const std::string& place, const std::string& expected, const Json& got) {
    if (problem_.empty())
      problem_ = (place.empty() ? "" : place + ".") + kLearn + " must be " + expected + ", got " + shown(got);
  }

  void check(const Json& json, const Json& mark, const std::string& place) {
    if (json.contains("value")) {
      const bool is_range = mark.is_array() && mark.size() == 2 && mark[0].is_number() && mark[1].is_number() &&
                            mark[0].get<double>() < mark[1].get<double>();
      if (!is_range) refuse(place, "a range [least, most]", mark);
    } else if (place.empty()) {
      check_conditions(mark);
    } else if (!json.contains("do")) {
      refuse(place, "beside a value, or beside 'do' in a rule", mark);
    } else {
      check_actions(mark, place);
    }
  }

  void check_actions(const Json& mark, const std::string& place) {
    bool good = mark.is_array() && !mark.empty();
    for (const Json& action : mark) good = good && action.is_object() && action.contains("do");
    if (!good) refuse(place, "a list of rules with 'do'", mark);
  }

  void check_conditions(const Json& mark) {
    const bool good =
        mark.is_object() && mark.size() == 1 && mark.contains("conditions") && mark["conditions"].is_array();
    if (!good) return refuse("", "{\"conditions\": [features]}", mark);
    for (const Json& name : mark["conditions"]) {
      if (!name.is_string()) return refuse("", "{\"conditions\": [features]}", mark);
      if (const auto feature = feature_named(name.get_ref<const std::string&>()); !feature && problem_.empty())
        problem_ = "learn.conditions: " + feature.error();
    }
  }

  std::string problem_;
};

}  // namespace

Result<Json> without_marks(const Json& strategy) {
  Cleaner cleaner;
  Json cleaned = cleaner.clean(strategy, "");
  if (!cleaner.problem().empty()) return Error{cleaner.problem()};
  return cleaned;
}

}  // namespace sim::io
