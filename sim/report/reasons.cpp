#include "sim/report/reasons.h"

#include <cmath>
#include <set>

#include "robot/core/json_library.h"
#include "sim/debug/coverage.h"

namespace sim::report {
namespace {

using debug::Reason, debug::Source, debug::Why, debug::WhyNot;

Json number(float value) { return std::isnan(value) ? Json() : Json(value); }

/// Returns a threshold or a margin with its unit, or null for a feature that is no number.
Json quantity_json(agent::Feature feature, float value) {
  const bool is_number = agent::info_of(feature).kind == agent::FeatureInfo::Kind::number;
  return is_number && !std::isnan(value) ? Json(debug::value_text(feature, value)) : Json();
}

/// Returns the index of the outermost part to whose names the path of a node or leaf belongs.
std::size_t part_of(const debug::Parts& parts, const std::string& path) {
  for (std::size_t i = 0; i < parts.all().size(); ++i) {
    const std::string& whole = parts.all()[i].path;
    if (whole.starts_with(path) && (whole.size() == path.size() || whole[path.size()] == '/')) return i;
  }
  return 0;
}

Json sources_json(const Reason& reason, bool has_truth) {
  Json all = Json::array();
  for (Source source : reason.sources) {
    const bool is_place = source.kind != Source::Kind::memory && source.kind != Source::Kind::game;
    if (!has_truth || !is_place) source.error = agent::kUnknown;
    all.push_back({{"text", text_of(source)},
                   {"age", source.age < 0 ? Json() : Json(source.age)},
                   {"error", number(source.error)}});
  }
  return all;
}

Json reason_json(const Reason& reason, const agent::Tree& tree, bool has_truth) {
  const agent::Node& node = tree.nodes[reason.node];
  const agent::Feature feature = node.feature;
  const auto text = [&](float value) { return debug::value_text(feature, value); };
  Json other;
  if (!std::isnan(reason.flip.value)) {
    const agent::Words& leaf = tree.leaf_words[reason.by_value];
    other = {{"skill", leaf.name}, {"leaf", leaf.path}};
  }
  return {{"node", reason.node},
          {"feature", agent::info_of(feature).name},
          {"value", text(reason.answer.value)},
          {"truth", has_truth ? Json(text(reason.truth)) : Json()},
          {"misled",
           has_truth && agent::holds(node.comparison, reason.truth, reason.answer.threshold) != reason.answer.result},
          {"threshold", quantity_json(feature, reason.answer.threshold)},
          {"margin", quantity_json(feature, reason.margin)},
          {"flip", std::isnan(reason.flip.value) ? Json() : Json(text(reason.flip.value))},
          {"other", std::move(other)},
          {"sources", sources_json(reason, has_truth)}};
}

const char* kind_word(WhyNot::Kind kind) {
  switch (kind) {
    case WhyNot::Kind::reached: return "reached";
    case WhyNot::Kind::changed: return "changed";
    case WhyNot::Kind::unreachable: return "unreachable";
    case WhyNot::Kind::unsure: break;
  }
  return "unsure";
}

}  // namespace

Json to_json(const Why& why, const agent::Tree& tree, const std::string& name, bool has_truth) {
  Json all{{"robot", name},
           {"skill", why.skill},
           {"role", why.role},
           {"strategy", tree.name},
           {"sentence", sentence_of(why, tree, name)},
           {"plays", why.plays},
           {"parts", Json::array()},
           {"comparisons", Json::array()},
           {"path", Json::array()},
           {"narrowest", why.narrowest ? Json(*why.narrowest) : Json()}};
  if (!why.plays) return all;

  const debug::Parts parts(tree);
  const std::vector<std::size_t>& around = parts.around(why.leaf);
  const std::set<std::size_t> taken(around.begin(), around.end());
  for (std::size_t i = 0; i < parts.all().size(); ++i) {
    const debug::Part& part = parts.all()[i];
    all["parts"].push_back({{"path", part.path},
                            {"name", part.name},
                            {"depth", part.depth},
                            {"skill", part.skill.empty() ? Json() : Json(part.skill)},
                            {"taken", taken.contains(i)}});
  }
  const debug::Evaluation& evaluation = why.evaluation;
  for (std::size_t i = tree.nodes.size(); i-- > 0;) {
    const agent::Feature feature = tree.nodes[i].feature;
    const debug::Answer& answer = evaluation.nodes[i];
    all["comparisons"].push_back({{"node", i},
                                  {"part", part_of(parts, tree.node_words[i].path)},
                                  {"condition", tree.node_words[i].condition},
                                  {"result", answer.result},
                                  {"value", debug::value_text(feature, answer.value)},
                                  {"threshold", quantity_json(feature, answer.threshold)}});
  }
  for (const Reason& reason : why.path) all["path"].push_back(reason_json(reason, tree, has_truth));
  return all;
}

Json to_json(const debug::Alternative& answer, const agent::Tree& tree, const std::string& name,
             const std::string& what) {
  const WhyNot& found = answer.features;
  const bool arrives = found.kind == WhyNot::Kind::reached || found.kind == WhyNot::Kind::changed;
  Json all{{"kind", kind_word(found.kind)},
           {"leaf", arrives ? Json(tree.leaf_words[found.leaf].path) : Json()},
           {"features", Json::array()},
           {"thresholds", Json()},
           {"beliefs", Json()},
           {"text", text_of(answer, tree, name, what)}};
  for (const debug::NewValue& change : found.values)
    all["features"].push_back({{"name", agent::info_of(change.feature).name},
                               {"before", debug::value_text(change.feature, change.before)},
                               {"after", debug::value_text(change.feature, change.after)},
                               {"text", debug::bound_text(change)}});
  if (answer.thresholds) {
    all["thresholds"] = Json::array();
    for (const debug::NewThreshold& change : *answer.thresholds) {
      const agent::Feature feature = tree.nodes[change.node].feature;
      all["thresholds"].push_back({{"node", change.node},
                                   {"condition", tree.node_words[change.node].condition},
                                   {"before", debug::value_text(feature, change.before)},
                                   {"after", debug::value_text(feature, change.after)}});
    }
  }
  if (answer.beliefs)
    all["beliefs"] = {{"changes", answer.beliefs->changes}, {"leaf", tree.leaf_words[answer.beliefs->leaf].path}};
  return all;
}

}  // namespace sim::report
