#include "sim/io/vocabulary.h"

#include <algorithm>
#include <cmath>
#include <vector>

#include "robot/core/json_library.h"
#include "sim/io/condition.h"
#include "sim/io/values.h"
#include "sim/io/words.h"

namespace sim::io {

using agent::Comparison;
using agent::Feature;
using agent::FeatureInfo;
using agent::ParameterInfo;
using agent::Skill;
using agent::SkillInfo;
using robot::Error;
using robot::Result;

namespace {

constexpr std::size_t kArgumentColumn = 16, kDefaultColumn = 52, kArgumentExampleColumn = 88;  // letters
constexpr std::size_t kNameColumn = 24, kRangeColumn = 20, kExampleColumn = 34;                // letters

std::vector<std::string_view> all_skills() {
  std::vector<std::string_view> names;
  for (int i = 0; i < agent::skill_count(); ++i) names.emplace_back(info_of(static_cast<Skill>(i)).name);
  return names;
}

/// Adds spaces up to that column, and at least two.
std::string padded(std::string text, std::size_t column) {
  text.resize(std::max(text.size() + 2, column), ' ');
  return text;
}

/// Returns a threshold that a tree may have: usual for the unit if the range has it, otherwise in the middle.
float usual_threshold(const FeatureInfo& info) {
  constexpr struct {
    std::string_view unit;
    float value;
  } kUsual[] = {{"m", 0.5f}, {"rad", 0.35f}, {"s", 2}, {"m/s", 0.3f}, {"robots", 2}, {"decisions", 3}};
  for (const auto& [unit, value] : kUsual)
    if (unit == info.unit && value > info.least && value < info.most) return value;
  const float middle = (info.least + info.most) / 2;
  return info.most - info.least > 2 ? std::floor(middle) : middle;
}

std::string range_text(const Expected& expected) {
  std::string words;
  for (const char* const* name = expected.names; name && *name; ++name)
    words += (words.empty() ? "" : ", ") + std::string(*name);
  if (!words.empty()) return words;
  return short_text(expected.least) + " .. " + value_text(expected.most, expected);
}

void add_range(Json& json, const Expected& expected) {
  if (expected.names) {
    Json& words = json["values"] = Json::array();
    for (const char* const* name = expected.names; *name; ++name) words.push_back(*name);
    return;
  }
  json["unit"] = expected.unit;
  json["least"] = short_number(expected.least);
  json["most"] = short_number(expected.most);
}

/// Returns the default of a parameter as a tree may write it: 1, "0.2 rad", "opening"; null for an optional one.
Json standard_of(const ParameterInfo& info) {
  if (!agent::is_given(info.standard)) return nullptr;
  if (!info.range.names && !*info.range.unit) return short_number(info.standard);
  return value_text(info.standard, expected_of(info));
}

/// Returns an example of an argument as a tree writes it: `"range": "3 m"`.
std::string written_example(const ParameterInfo& info) {
  const std::string value = info.range.example ? info.range.example : standard_of(info).dump();
  return quoted(info.key()) + ": " + value;
}

/// Returns the line of an argument for people.
std::string line_of(const ParameterInfo& info) {
  const Expected expected = expected_of(info);
  const std::string standard =
      agent::is_given(info.standard) ? "default " + value_text(info.standard, expected) : "optional";
  std::string text = padded("  " + std::string(info.name), kArgumentColumn);
  text += padded(range_text(expected) + (info.range.names_kicks ? ", a kick" : "") + "; " + standard, kDefaultColumn);
  return padded(text + written_example(info), kArgumentExampleColumn) + info.about + "\n";
}

}  // namespace

std::vector<std::string_view> all_features() {
  std::vector<std::string_view> names;
  for (int i = 0; i < agent::feature_count(); ++i) names.emplace_back(info_of(static_cast<Feature>(i)).name);
  return names;
}

Result<Skill> skill_named(std::string_view name) {
  const Skill skill = agent::find_skill(name);
  if (skill != agent::kNoSkill) return skill;
  return Error{"no skill " + quoted(name) + hint(name, all_skills())};
}

Result<Feature> feature_named(std::string_view name) {
  const Feature feature = agent::find_feature(name);
  if (feature != agent::kNoFeature) return feature;
  return Error{"no feature " + quoted(name) + hint(name, all_features())};
}

std::string example_of(Skill skill) {
  const SkillInfo& info = info_of(skill);
  Json rule = Json::object();
  rule["do"] = info.name;
  for (int i = 0; i < info.count; ++i) {
    const ParameterInfo& parameter = info.parameters[i];
    Json standard = standard_of(parameter);
    if (standard.is_null()) continue;
    if (parameter.range.point)
      rule["with"][parameter.key()].push_back(std::move(standard));
    else
      rule["with"][parameter.key()] = std::move(standard);
  }
  return rule.dump();
}

std::string example_of(Feature feature) {
  const FeatureInfo& info = info_of(feature);
  Term term{.feature = feature, .comparison = Comparison::less, .threshold = 0, .text = {}};
  if (info.kind == FeatureInfo::Kind::yes_no) term.comparison = Comparison::greater;
  if (info.kind == FeatureInfo::Kind::name) term.comparison = Comparison::equal;
  if (info.kind == FeatureInfo::Kind::number) term.threshold = usual_threshold(info);
  return text_of(term);
}

Json json_of(Skill skill) {
  const SkillInfo& info = info_of(skill);
  Json json = Json::object();
  json["name"] = info.name;
  json["about"] = info.about;
  json["own"] = static_cast<int>(skill) >= agent::built_in_skill_count();
  Json& parameters = json["arguments"] = Json::array();
  for (int i = 0; i < info.count; ++i) {
    const ParameterInfo& parameter = info.parameters[i];
    Json described = Json::object();
    described["name"] = parameter.name;
    described["about"] = parameter.about;
    add_range(described, expected_of(parameter));
    if (parameter.range.names_kicks) described["values"].push_back("a kick of the model");
    if (parameter.range.point) described["point"] = parameter.range.point;
    const Json standard = standard_of(parameter);
    const bool is_word = parameter.range.names || standard.is_null();
    described["default"] = is_word ? standard : Json(short_number(parameter.standard));
    described["example"] = written_example(parameter);
    parameters.push_back(std::move(described));
  }
  json["example"] = example_of(skill);
  return json;
}

Json json_of(Feature feature) {
  constexpr const char* kKinds[] = {"number", "yes_no", "name"};  // by Kind
  const FeatureInfo& info = info_of(feature);
  Json json = Json::object();
  json["name"] = info.name;
  json["about"] = info.about;
  json["own"] = static_cast<int>(feature) >= agent::built_in_feature_count();
  json["kind"] = kKinds[static_cast<int>(info.kind)];
  if (info.kind != FeatureInfo::Kind::yes_no) add_range(json, expected_of(info));
  json["needs_ball"] = info.needs_ball;
  json["example"] = example_of(feature);
  return json;
}

std::string text_of(Skill skill) {
  const SkillInfo& info = info_of(skill);
  std::string text = std::string(info.name) + ": " + info.about + "\n";
  for (int i = 0; i < info.count; ++i) text += line_of(info.parameters[i]);
  return text + "  example: " + example_of(skill) + "\n";
}

std::string text_of(Feature feature) {
  const FeatureInfo& info = info_of(feature);
  const bool is_number = info.kind == FeatureInfo::Kind::number;
  const std::string range = is_number                                ? range_text(expected_of(info))
                            : info.kind == FeatureInfo::Kind::yes_no ? "yes or no"
                                                                     : "a word";
  return padded(std::string(info.name) + (info.needs_ball ? " *" : ""), kNameColumn) + padded(range, kRangeColumn) +
         padded(example_of(feature), kExampleColumn) + info.about + "\n";
}

}  // namespace sim::io
