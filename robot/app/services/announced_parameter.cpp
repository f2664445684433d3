#include "robot/app/services/announced_parameter.h"

#include <algorithm>
#include <cctype>
#include <cmath>
#include <cstdint>
#include <utility>

#include "robot/core/text.h"

namespace robot::app {
namespace {

using foresight::LiveParameter;

constexpr double kLargestWhole = 9007199254740992;  // 2^53: a double holds each whole number up to it

bool is_word(std::string_view text, std::string_view signs, std::size_t max_bytes) {
  return !text.empty() && text.size() <= max_bytes && std::ranges::all_of(text, [&](unsigned char byte) {
    return byte < 0x80 && (std::isalnum(byte) || signs.find(static_cast<char>(byte)) != signs.npos);
  });
}

Error wrong(const LiveParameter& announced, const std::string& expected) {
  return Error{"parameter '" + printable(announced.name(), 60) + "': expected " + expected};
}

/// Returns a value of the announced type, or nothing if it is not of this type.
std::optional<net::ParameterValue> value_of(LiveParameter::Type type, double number, const std::string& text) {
  switch (type) {
    case LiveParameter::TYPE_NUMBER: return number;
    case LiveParameter::TYPE_WHOLE:
    case LiveParameter::TYPE_BUTTON:
      if (!(std::abs(number) <= kLargestWhole) || std::nearbyint(number) != number) return std::nullopt;
      return static_cast<std::int64_t>(number);
    case LiveParameter::TYPE_YES_NO:
      if (number != 0 && number != 1) return std::nullopt;
      return number == 1;
    case LiveParameter::TYPE_TEXT:
    case LiveParameter::TYPE_CHOICE: return text;
    default: return std::nullopt;
  }
}

Result<void> check_words(const LiveParameter& announced) {
  if (!is_word(announced.name(), "_-.", kMaxNameBytes))
    return wrong(announced, "a name of 1 to " + std::to_string(kMaxNameBytes) + " letters, digits, '_', '-' and '.'");
  if (announced.unit().size() > kMaxUnitBytes)
    return wrong(announced, "a unit of at most " + std::to_string(kMaxUnitBytes) + " bytes");
  if (announced.description().size() > kMaxTextBytes)
    return wrong(announced, "a description of at most " + std::to_string(kMaxTextBytes) + " bytes");
  return {};
}

/// Returns the range of a number, whole number, or choice.
Result<net::ParameterRule> rule_of(const LiveParameter& announced) {
  net::ParameterRule rule;
  const double min = announced.min(), max = announced.max();
  if (min != 0 || max != 0) {
    if (!(min < max)) return wrong(announced, "a range whose minimum is below its maximum");
    if (std::isfinite(min)) rule.min = min;
    if (std::isfinite(max)) rule.max = max;
  }
  if (announced.type() == LiveParameter::TYPE_BUTTON) rule.min = 0;
  if (announced.type() == LiveParameter::TYPE_WHOLE) {
    rule.min = std::max(rule.min.value_or(-kLargestWhole), -kLargestWhole);
    rule.max = std::min(rule.max.value_or(kLargestWhole), kLargestWhole);
  }
  if (announced.type() != LiveParameter::TYPE_CHOICE) return rule;
  if (announced.choice_size() < 1 || announced.choice_size() > kMaxChoices)
    return wrong(announced,
                 "1 to " + std::to_string(kMaxChoices) + " choices, got " + std::to_string(announced.choice_size()));
  for (const std::string& choice : announced.choice()) {
    if (choice.empty() || choice.size() > kMaxNameBytes)
      return wrong(announced, "choices of 1 to " + std::to_string(kMaxNameBytes) + " bytes");
    rule.choices.push_back(choice);
  }
  return rule;
}

}  // namespace

bool is_process_name(std::string_view name) { return is_word(name, "_-", kMaxProcessBytes); }

Result<net::OfferedParameter> offered_parameter(const LiveParameter& announced, const std::string& process) {
  if (Result<void> words = check_words(announced); !words) return words.failure();
  if (announced.type() == LiveParameter::TYPE_UNSPECIFIED || !LiveParameter::Type_IsValid(announced.type()))
    return wrong(announced, "a number, whole number, yes or no, text, choice or button, got another type");
  Result<net::ParameterRule> rule = rule_of(announced);
  if (!rule) return rule.failure();
  auto initial = value_of(announced.type(), announced.initial_number(), announced.initial_text());
  auto present = value_of(announced.type(), announced.number(), announced.text());
  if (!initial || !present) return wrong(announced, "values of its type, got others");
  for (const net::ParameterValue& value : {*initial, *present}) {
    if (Result<void> inside = net::check_value(announced.name(), value, *rule); !inside) return inside.failure();
    if (const auto* text = std::get_if<std::string>(&value); text && text->size() > kMaxTextBytes)
      return wrong(announced, "a text of at most " + std::to_string(kMaxTextBytes) + " bytes");
  }
  return net::OfferedParameter{.name = process + "." + announced.name(),
                               .initial = *std::move(initial),
                               .present = *std::move(present),
                               .rule = *std::move(rule)};
}

void put_value(LiveParameter& parameter, const net::ParameterValue& value) {
  if (const auto* text = std::get_if<std::string>(&value)) return parameter.set_text(*text);
  if (const auto* number = std::get_if<double>(&value)) return parameter.set_number(*number);
  if (const auto* whole = std::get_if<std::int64_t>(&value)) return parameter.set_number(static_cast<double>(*whole));
  parameter.set_number(std::get<bool>(value) ? 1 : 0);
}

}  // namespace robot::app
