#include "sim/learn/knobs.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <utility>

#include "robot/core/json_library.h"
#include "robot/core/text.h"
#include "sim/io/condition.h"
#include "sim/io/marks.h"
#include "sim/io/vocabulary.h"
#include "sim/learn/rules.h"
#include "sim/math/angles.h"

namespace sim::learn {
namespace {

using io::Json;
using robot::Result;

constexpr float kFactor = 3;        // of a value, to each side of it
constexpr float kShare = 0.25;      // of the allowed range, for a number that may be negative
constexpr float kSteps = 100;       // of a range
constexpr double kRounding = 1e-4;  // of a step

bool is_angle(const io::Expected& expected) { return std::string_view(expected.unit) == "rad"; }

void limit(const io::Expected& expected, Knob& knob) {
  knob.least = std::max(knob.least, expected.least);
  knob.most = std::min(knob.most, expected.most);
}

/// Sets the range of a number without a mark. A value that is farther than `farthest` stays in its range.
void guess_range(Knob& knob, float farthest) {
  const float value = knob.value, room = kShare * (knob.expected.most - knob.expected.least);
  const bool positive = value > 0 && knob.expected.least >= 0;
  knob.least = positive ? value / kFactor : value - room;
  knob.most = positive ? value * kFactor : value + room;
  limit(knob.expected, knob);
  if (std::string_view(knob.expected.unit) != "m") return;
  knob.least = std::max(knob.least, std::min(value, -farthest));
  knob.most = std::min(knob.most, std::max(value, farthest));
}

/// Finds the numbers of one strategy.
class Finder {
 public:
  Finder(const Json& marked, const Json& plain, float farthest)
      : farthest_(farthest), marked_(marked), plain_(plain), parameters_(plain.value("parameters", Json::object())) {}

  std::vector<Knob> find() {
    for_each_rule(plain_, [&](const RulePlace& place, const Json& rule) { add_rule(place, rule); });
    std::vector<Knob> knobs;
    for (const auto& [name, value] : parameters_.items())
      if (const auto found = of_parameters_.find(name); found != of_parameters_.end()) knobs.push_back(found->second);
    std::ranges::move(direct_, std::back_inserter(knobs));
    std::erase_if(knobs, [](const Knob& knob) { return !(knob.least < knob.most); });
    return knobs;
  }

 private:
  void add_rule(const RulePlace& place, const Json& rule) {
    if (rule.contains("if")) add_condition(place, rule["if"]);
    if (rule.contains("do") && rule.contains("with")) add_arguments(place, rule);
  }

  void add_condition(const RulePlace& place, const Json& condition) {
    io::Values values(parameters_);
    const auto parsed = io::parse_condition(condition.get_ref<const std::string&>(), values);
    if (!parsed) return;
    int number = 0;
    for (const auto& terms : parsed->alternatives)
      for (const io::Term& term : terms) add_term(place, term, number++);
  }

  void add_term(const RulePlace& place, const io::Term& term, int number) {
    const agent::FeatureInfo& info = info_of(term.feature);
    const bool is_number = info.kind == agent::FeatureInfo::Kind::number && term.other == agent::kNoFeature;
    if (!is_number || info.fixed || counts(info)) return;
    Knob knob{.name = place.name + ": " + info.name,
              .place = place.pointer + "/if",
              .term = number,
              .expected = io::expected_of(info),
              .value = term.threshold,
              .skills = {},
              .features = {info.name}};
    const std::size_t parameter = term.text.find('$');
    if (parameter == term.text.npos) return add_direct(std::move(knob));
    add_use(std::string(robot::trimmed(term.text.substr(parameter + 1))), std::move(knob));
  }

  void add_arguments(const RulePlace& place, const Json& rule) {
    const auto skill = io::skill_named(rule["do"].get_ref<const std::string&>());
    if (!skill) return;
    const agent::SkillInfo& info = info_of(*skill);
    for (int i = 0; i < info.count; ++i) {
      const agent::ParameterInfo& argument = info.parameters[i];
      const bool is_number = !argument.range.names && !argument.range.names_kicks && !argument.range.point &&
                             std::string_view(argument.range.unit) != "decisions";
      const auto given = rule["with"].find(argument.name);
      if (!is_number || given == rule["with"].end()) continue;
      Knob knob{.name = place.name + ": " + argument.name,
                .place = place.pointer + "/with/" + argument.name,
                .expected = io::expected_of(argument),
                .skills = {info.name},
                .features = {}};
      io::Values values(parameters_);
      const auto value = values.read(*given, knob.expected);
      if (!value) continue;
      knob.value = *value;
      const bool is_parameter = given->is_string() && given->get_ref<const std::string&>().starts_with('$');
      if (is_parameter)
        add_use(given->get_ref<const std::string&>().substr(1), std::move(knob));
      else
        add_direct(std::move(knob));
    }
  }

  /// Adds a use of a parameter: its value must be allowed in all of them.
  void add_use(const std::string& parameter, Knob use) {
    const auto [place, is_new] = of_parameters_.try_emplace(parameter, use);
    Knob& knob = place->second;
    if (is_new) {
      knob.name = parameter, knob.place = "/parameters/" + parameter, knob.term = -1;
      set_range(knob);
      return;
    }
    limit(use.expected, knob);
    std::ranges::move(use.skills, std::back_inserter(knob.skills));
    std::ranges::move(use.features, std::back_inserter(knob.features));
  }

  void add_direct(Knob knob) {
    set_range(knob);
    direct_.push_back(std::move(knob));
  }

  void set_range(Knob& knob) const {
    const Json::json_pointer place(knob.place);
    const Json* const mark = knob.term < 0 && marked_.contains(place) ? &marked_.at(place) : nullptr;
    if (!mark || !mark->is_object()) return guess_range(knob, farthest_);
    // the range has the unit of the value
    const Json& value = (*mark)["value"];
    const std::string text = value.is_string() ? value.get<std::string>() : "";
    const std::size_t unit = text.find(' ');
    const auto end = [&](std::size_t which, float otherwise) {
      io::Values values;
      const std::string written = robot::formatted("%.9g", (*mark)["learn"][which].get<double>());
      const std::string whole = unit == text.npos ? written : written + text.substr(unit);
      const auto read = values.read(std::string_view(whole), knob.expected);
      return read ? *read : otherwise;
    };
    knob.least = end(0, knob.expected.least), knob.most = end(1, knob.expected.most);
  }

  const float farthest_;  // [m]
  const Json& marked_;
  const Json& plain_;
  const Json parameters_;
  std::map<std::string, Knob> of_parameters_;
  std::vector<Knob> direct_;
};

/// Returns the condition with another text for the threshold of one comparison.
std::string with_threshold(const std::string& condition, const Json& parameters, int number,
                           const std::string& threshold) {
  io::Values values(parameters);
  const auto parsed = io::parse_condition(condition, values);
  if (!parsed) return condition;
  std::vector<std::string> alternatives;
  int at = 0;
  for (const auto& terms : parsed->alternatives) {
    std::vector<std::string> texts;
    for (const io::Term& term : terms) texts.push_back(at++ == number ? io::text_of(term, threshold) : term.text);
    alternatives.push_back(robot::joined(texts, " and "));
  }
  return robot::joined(alternatives, " or ");
}

}  // namespace

Result<std::vector<Knob>> knobs_of(const Json& strategy, float farthest) {
  const Result<Json> plain = io::without_marks(strategy);
  if (!plain) return plain.failure();
  return Finder(strategy, *plain, farthest).find();
}

float rounded(const Knob& knob, float value) {
  const double scale = is_angle(knob.expected) ? static_cast<double>(kDegrees) : 1;
  const double range = scale * static_cast<double>(knob.most - knob.least) / static_cast<double>(kSteps);
  double step = 1;  // 1, 2 or 5 times a power of ten, not above the hundredth
  while (step > range) step /= 10;
  while (step * 10 <= range) step *= 10;
  step *= step * 5 <= range ? 5 : step * 2 <= range ? 2 : 1;
  // the outermost steps within the range
  const double first = std::ceil(scale * static_cast<double>(knob.least) / step - kRounding);
  const double last = std::floor(scale * static_cast<double>(knob.most) / step + kRounding);
  const double nearest = std::clamp(std::round(scale * static_cast<double>(value) / step), first, last);
  return static_cast<float>(nearest * step / scale);
}

std::string text_of(const Knob& knob, float value) {
  if (is_angle(knob.expected)) return robot::formatted("%.6g deg", static_cast<double>(value * kDegrees));
  return robot::formatted("%.6g%s%s", static_cast<double>(value), *knob.expected.unit ? " " : "", knob.expected.unit);
}

Json with_values(Json strategy, std::span<const Knob> knobs, std::span<const float> values) {
  const Result<Json> plain = io::without_marks(strategy);
  const Json parameters = plain ? plain->value("parameters", Json::object()) : Json::object();
  for (std::size_t i = 0; i < knobs.size(); ++i) {
    const Knob& knob = knobs[i];
    if (values[i] == knob.value) continue;
    Json& place = strategy.at(Json::json_pointer(knob.place));
    Json& text = place.is_object() ? place["value"] : place;
    if (knob.term >= 0)
      text = with_threshold(text.get<std::string>(), parameters, knob.term, text_of(knob, values[i]));
    else if (*knob.expected.unit)
      text = text_of(knob, values[i]);
    else
      text = io::short_number(values[i]);
  }
  return strategy;
}

std::vector<Change> changes(std::span<const Knob> knobs, std::span<const float> values) {
  std::vector<Change> lines;
  for (std::size_t i = 0; i < knobs.size(); ++i)
    if (values[i] != knobs[i].value)
      lines.push_back({knobs[i].name, text_of(knobs[i], knobs[i].value), text_of(knobs[i], values[i])});
  return lines;
}

}  // namespace sim::learn
