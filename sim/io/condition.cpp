#include "sim/io/condition.h"

#include "robot/core/json_library.h"
#include "robot/core/text.h"
#include "sim/io/vocabulary.h"
#include "sim/io/words.h"

namespace sim::io {

using agent::Comparison;
using agent::Feature;
using agent::FeatureInfo;
using robot::Error;
using robot::Result;
using robot::split;
using robot::trimmed;

namespace {

/// A comparison operator as written. An operator comes before any that is its beginning.
struct Operator {
  std::string_view text;
  Comparison comparison;
  bool of_names;
};
constexpr Operator kOperators[] = {
    {"<=", Comparison::at_most, false}, {">=", Comparison::at_least, false},     {"<", Comparison::less, false},
    {">", Comparison::greater, false},  {" is not ", Comparison::unequal, true}, {" is ", Comparison::equal, true},
};

/// Parses the term of a yes-or-no feature: "our_kick".
Result<Term> parse_yes_no(std::string_view text) {
  const Result<Feature> feature = feature_named(text);
  if (!feature) return feature.failure();
  const FeatureInfo& info = info_of(*feature);
  if (info.kind != FeatureInfo::Kind::yes_no)
    return Error{std::string(info.name) + " must be compared with a value, got " + quoted(text)};
  return Term{.feature = *feature, .comparison = Comparison::greater, .threshold = 0.5f, .text = {}};
}

/// Returns the reason why two features cannot be compared with each other, or "".
std::string reason_against(const FeatureInfo& left, const FeatureInfo& right) {
  const std::string both = std::string(left.name) + " and " + right.name;
  if (left.kind != FeatureInfo::Kind::number || right.kind != FeatureInfo::Kind::number)
    return both + " cannot be compared, because both must be numbers";
  if (std::string_view(left.unit) != right.unit)
    return both + " must have one unit, got [" + left.unit + "] and [" + right.unit + "]";
  if (left.lateral != right.lateral)
    return both + " cannot be compared, because only " + (left.lateral ? left : right).name +
           " changes its sign when left and right are exchanged";
  return {};
}

/// Parses the right side of a comparison, a feature or a value, into `term`. Returns the reason against it, or "".
std::string parse_right(std::string_view text, Values& values, Term& term) {
  const FeatureInfo& info = info_of(term.feature);
  const Feature other = agent::find_feature(text);
  if (other != agent::kNoFeature && info.kind == FeatureInfo::Kind::number) {
    term.other = other;
    return reason_against(info, info_of(other));
  }
  const Result<float> threshold = values.read(text, expected_of(info));
  if (threshold) {
    term.threshold = *threshold;
    return {};
  }
  // a word may be a mistyped feature
  const bool is_word = !text.empty() && text.front() >= 'a' && text.front() <= 'z' && !info.names;
  return "the value for " + std::string(info.name) + " " + threshold.error() +
         (is_word ? did_you_mean(text, all_features()) : "");
}

/// Parses a comparison without "not".
Result<Term> parse_comparison(std::string_view text, Values& values) {
  for (const Operator& each : kOperators) {
    const std::size_t at = text.find(each.text);
    if (at == text.npos) continue;
    const Result<Feature> feature = feature_named(trimmed(text.substr(0, at)));
    if (!feature) return feature.failure();
    const FeatureInfo& info = info_of(*feature);
    if (info.kind == FeatureInfo::Kind::yes_no)
      return Error{std::string(info.name) + " is yes or no and must stand alone, got " + quoted(text)};
    if (each.of_names != (info.kind == FeatureInfo::Kind::name))
      return Error{std::string(info.name) + " is compared by " + (each.of_names ? "< <= > >=" : "is, is not") +
                   ", got " + quoted(text)};
    Term term{.feature = *feature, .comparison = each.comparison, .threshold = 0, .text = {}};
    if (std::string reason = parse_right(trimmed(text.substr(at + each.text.size())), values, term); !reason.empty())
      return Error{std::move(reason)};
    return term;
  }
  return parse_yes_no(text);
}

Result<Term> parse_term(std::string_view text, Values& values) {
  constexpr std::string_view kNot = "not ";
  if (text.empty()) return Error{"a comparison is missing"};
  const bool is_negated = text.starts_with(kNot);
  Result<Term> term = parse_comparison(is_negated ? trimmed(text.substr(kNot.size())) : text, values);
  if (!term) return term;
  if (is_negated) term->comparison = negated(term->comparison);
  term->text = text;
  return term;
}

}  // namespace

std::string text_of(const Term& term) {
  return text_of(term, value_text(term.threshold, expected_of(info_of(term.feature))));
}

std::string text_of(const Term& term, const std::string& threshold) {
  const FeatureInfo& info = info_of(term.feature);
  std::string name = info.name;
  if (info.kind == FeatureInfo::Kind::yes_no) return (term.comparison == Comparison::greater ? "" : "not ") + name;
  for (const Operator& each : kOperators)
    if (each.comparison == term.comparison)
      return name + " " + std::string(trimmed(each.text)) + " " +
             (term.other == agent::kNoFeature ? threshold : info_of(term.other).name);
  return name;
}

Result<Condition> parse_condition(std::string_view text, Values& values) {
  if (text.size() > kMaxConditionBytes)
    return Error{"must have at most " + std::to_string(kMaxConditionBytes) + " bytes, got " +
                 std::to_string(text.size())};
  Condition condition;
  for (const std::string_view alternative : split(text, " or ")) {
    std::vector<Term>& terms = condition.alternatives.emplace_back();
    for (const std::string_view part : split(alternative, " and ")) {
      Result<Term> term = parse_term(trimmed(part), values);
      if (!term) return term.failure();
      terms.push_back(std::move(*term));
    }
  }
  return condition;
}

}  // namespace sim::io
