#include "sim/debug/flip.h"

#include <cmath>
#include <limits>
#include <string>
#include <string_view>

#include "sim/io/condition.h"

namespace sim::debug {

using agent::Comparison;
using agent::FeatureInfo;
using Kind = FeatureInfo::Kind;

namespace {

constexpr float kFar = std::numeric_limits<float>::infinity();

float next_above(float value, bool whole) { return whole ? std::floor(value) + 1 : std::nextafter(value, kFar); }
float next_below(float value, bool whole) { return whole ? std::ceil(value) - 1 : std::nextafter(value, -kFar); }

/// Returns the comparison that asks the same with both sides exchanged.
Comparison exchanged(Comparison comparison) {
  switch (comparison) {
    case Comparison::less: return Comparison::greater;
    case Comparison::greater: return Comparison::less;
    case Comparison::at_most: return Comparison::at_least;
    case Comparison::at_least: return Comparison::at_most;
    case Comparison::equal:
    case Comparison::unequal: break;
  }
  return comparison;
}

bool in_range(const FeatureInfo& info, float value) { return value >= info.least && value <= info.most; }

float other_value(const agent::Node& node, const Answer& answer, Comparison wanted) {
  const FeatureInfo& info = info_of(node.feature);
  if (info.fixed || std::isnan(answer.threshold)) return agent::kUnknown;
  if (info.kind == Kind::yes_no) {
    for (const float value : {0.f, 1.f})
      if (holds(wanted, value, answer.threshold)) return value;
    return agent::kUnknown;
  }
  const bool whole = info.kind == Kind::name || counts(info);
  float value = nearest_passing(wanted, answer.value, answer.threshold, whole);
  if (wanted == Comparison::unequal && !in_range(info, value)) value = next_below(answer.threshold, whole);
  return in_range(info, value) ? value : agent::kUnknown;
}

}  // namespace

float nearest_passing(Comparison comparison, float value, float threshold, bool whole) {
  switch (comparison) {
    case Comparison::less: return next_below(threshold, whole);
    case Comparison::greater: return next_above(threshold, whole);
    case Comparison::at_most: return whole ? std::floor(threshold) : threshold;
    case Comparison::at_least: return whole ? std::ceil(threshold) : threshold;
    case Comparison::equal: return whole && threshold != std::floor(threshold) ? agent::kUnknown : threshold;
    case Comparison::unequal: return value == threshold || std::isnan(value) ? next_above(threshold, whole) : value;
  }
  return agent::kUnknown;
}

Flip flip_of(const agent::Node& node, const Answer& answer) {
  const FeatureInfo& info = info_of(node.feature);
  // an unknown value fails, with and without "not": it flips by passing
  const Comparison wanted = answer.result ? negated(node.comparison) : node.comparison;
  Flip flip{.value = other_value(node, answer, wanted), .threshold = agent::kUnknown};
  if (node.other != agent::kNoFeature || std::isnan(answer.value) || info.kind == Kind::yes_no) return flip;
  float threshold = nearest_passing(exchanged(wanted), answer.threshold, answer.value, info.kind == Kind::name);
  if (wanted == Comparison::unequal && !in_range(info, threshold)) threshold = answer.value - 1;
  if (in_range(info, threshold)) flip.threshold = threshold;
  return flip;
}

float scale_of(const FeatureInfo& info) {
  // a third of a radian, a second, or one of anything else
  return std::string_view(info.unit) == "rad" ? 0.35f : 1.f;
}

agent::Tree with_threshold(agent::Tree tree, std::uint16_t node, float threshold) {
  agent::Node& changed = tree.nodes[node];
  changed.threshold = threshold;
  tree.node_words[node].condition = io::text_of({.feature = changed.feature,
                                                 .comparison = changed.comparison,
                                                 .threshold = threshold,
                                                 .text = {},
                                                 .other = changed.other});
  return tree;
}

}  // namespace sim::debug
