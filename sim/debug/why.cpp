#include "sim/debug/why.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "robot/core/text.h"
#include "sim/agent/roles.h"
#include "sim/agent/trace.h"

namespace sim::debug {

using agent::FeatureInfo;
using Kind = FeatureInfo::Kind;

namespace {

using robot::formatted;

Values with_value(Values values, agent::Feature feature, float value) {
  values[static_cast<std::size_t>(feature)] = value;
  return values;
}

std::string number_text(float value) { return formatted("%.3g", static_cast<double>(value)); }

/// Returns the condition with the value that answered it: "ball_distance < $near (0.31 m < 0.5 m)", or its opposite.
std::string said(const agent::Tree& tree, const Reason& reason) {
  const agent::Node& node = tree.nodes[reason.node];
  const FeatureInfo& info = info_of(node.feature);
  const std::string& condition = tree.node_words[reason.node].condition;
  if (info.kind != Kind::number) return condition;
  return condition + " (" + value_text(node.feature, reason.answer.value) + ")";
}

/// Returns the size of the margin, to compare features. It is infinite if the robot would play this skill anyway.
float narrowness(const agent::Tree& tree, const Reason& reason, const std::string& skill) {
  const FeatureInfo& info = info_of(tree.nodes[reason.node].feature);
  if (info.kind != Kind::number || std::isnan(reason.margin) || tree.leaf_words[reason.by_value].name == skill)
    return std::numeric_limits<float>::infinity();
  return std::abs(reason.margin) / scale_of(info);
}

/// Returns where a flip leads: a skill, or another leaf of the same skill.
std::string other_text(const Why& why, const agent::Tree& tree, std::uint16_t leaf) {
  if (leaf == why.leaf) return "the same leaf";
  return tree.leaf_words[leaf].name == why.skill ? leaf_text(tree, leaf) : tree.leaf_words[leaf].name;
}

std::string flip_text(const Why& why, const agent::Tree& tree, const Reason& reason) {
  const agent::Node& node = tree.nodes[reason.node];
  if (std::isnan(reason.flip.value))
    return std::isnan(reason.answer.threshold) ? "the other side is unknown" : "no other value answers otherwise";
  const std::string change = std::isnan(reason.margin)
                                 ? "if it were known, and " + value_text(node.feature, reason.flip.value)
                                 : "at " + value_text(node.feature, reason.flip.value);
  const char* sign = reason.margin > 0 ? "+" : "";
  const std::string margin = info_of(node.feature).kind != Kind::number || std::isnan(reason.margin)
                                 ? ""
                                 : " (" + (sign + value_text(node.feature, reason.margin)) + ")";
  return change + margin + ": " + other_text(why, tree, reason.by_value);
}

}  // namespace

std::string value_text(agent::Feature feature, float value) {
  const FeatureInfo& info = info_of(feature);
  if (std::isnan(value)) return "unknown";
  if (info.kind == Kind::yes_no) return value > 0.5f ? "yes" : "no";
  if (info.kind == Kind::name) return info.names[static_cast<int>(value)];
  const std::string_view unit = info.unit;
  if (unit == "rad") return number_text(kDegrees * value) + " deg";
  return number_text(value) + (unit.empty() ? "" : " ") + info.unit;
}

std::string leaf_text(const agent::Tree& tree, std::uint16_t leaf) {
  return tree.leaf_words[leaf].name + " (" + tree.leaf_words[leaf].path + ")";
}

Why why(const Params& params, const agent::TreeBehaviour& behaviour, const Decision& decision, const State& state) {
  const agent::Tree& tree = behaviour.tree();
  Why all;
  all.decision = decision, all.state = state, all.plays = agent::plays(decision.game);
  agent::Trace trace;
  decide(params, behaviour, decision, &trace);
  all.skill = trace.skill, all.role = trace.role;
  if (!all.plays) return all;

  const Thought thought(params, tree, decision);
  const Values values = values_of(tree, thought.view());
  all.evaluation = evaluate(tree, values);
  const Evaluation& evaluation = all.evaluation;
  all.leaf = evaluation.leaf;

  // the same questions, asked of somebody who knows everything
  Decision knowing = decision;
  knowing.beliefs = true_beliefs(state, decision.robot);
  knowing.mind = thought.mind();
  knowing.mind.leaf = 0;
  knowing.mind.settled = static_cast<std::uint8_t>(decision.tick);
  const Thought oracle(params, tree, knowing);

  for (const std::uint16_t number : evaluation.path) {
    const agent::Node& node = tree.nodes[number];
    Reason reason;
    reason.node = number, reason.answer = evaluation.nodes[number];
    reason.truth = value_of(node.feature, oracle.view());
    reason.flip = flip_of(node, reason.answer);
    reason.margin = std::isnan(reason.flip.value) ? agent::kUnknown : reason.flip.value - reason.answer.value;
    reason.branch = reason.answer.result ? node.no : node.yes;
    if (!std::isnan(reason.flip.value))
      reason.by_value = leaf_of(tree, with_value(values, node.feature, reason.flip.value));
    reason.by_threshold = leaf_from(tree, reason.branch, values);
    all.path.push_back(std::move(reason));
  }
  const auto narrowest =
      std::ranges::min_element(all.path, {}, [&](const Reason& reason) { return narrowness(tree, reason, all.skill); });
  if (narrowest != all.path.end() && std::isfinite(narrowness(tree, *narrowest, all.skill)))
    all.narrowest = static_cast<std::size_t>(narrowest - all.path.begin());
  return all;
}

void find_sources(const Params& params, const agent::Tree& tree, Why& why) {
  for (Reason& reason : why.path)
    reason.sources = sources_of(tree.nodes[reason.node].feature, params, tree, why.decision, why.state);
}

std::string sentence_of(const Why& why, const agent::Tree& tree, const std::string& name) {
  const std::string does = name + " plays " + why.skill;
  if (!why.plays)
    return does + (why.decision.game.penalised ? " because it is penalised" : " because the ball is not in play");
  std::string because;
  for (const Reason& reason : why.path)
    if (reason.answer.result) because += (because.empty() ? " because " : " and ") + said(tree, reason);
  if (because.empty()) because = " because no condition holds";
  if (!why.narrowest) return does + because;
  const Reason& close = why.path[*why.narrowest];
  const agent::Node& node = tree.nodes[close.node];
  return does + because + "; the closest call is " + info_of(node.feature).name + ", " +
         value_text(node.feature, close.answer.value) + ": at " + value_text(node.feature, close.flip.value) +
         " it plays " + tree.leaf_words[close.by_value].name;
}

std::string text_of(const Why& why, const agent::Tree& tree, const std::string& name) {
  std::string text = sentence_of(why, tree, name) + ".\n";
  if (!why.plays) return text;
  text += "\nleaf  " + leaf_text(tree, why.leaf) + "\nrole  " + why.role + "\n\n";
  text += formatted("%4s  %-38s %-4s %10s %10s %10s  %s\n", "node", "comparison", "", "believed", "true", "threshold",
                    "otherwise");
  for (const Reason& reason : why.path) {
    const agent::Node& node = tree.nodes[reason.node];
    const char* answer = std::isnan(reason.answer.value) ? "?" : reason.answer.result ? "yes" : "no";
    const bool is_number = info_of(node.feature).kind == Kind::number;
    text += formatted(
        "%4d  %-38s %-4s %10s %10s %10s  %s\n", reason.node, tree.node_words[reason.node].condition.c_str(), answer,
        value_text(node.feature, reason.answer.value).c_str(), value_text(node.feature, reason.truth).c_str(),
        is_number ? value_text(node.feature, reason.answer.threshold).c_str() : "",
        flip_text(why, tree, reason).c_str());
  }

  // each source once
  text += "\nread from\n";
  std::vector<std::string> told;
  for (const Reason& reason : why.path)
    for (const Source& source : reason.sources) {
      if (source.kind == Source::Kind::memory || source.kind == Source::Kind::game) continue;
      const std::string words = "  " + text_of(source) + "\n";
      if (std::ranges::find(told, words) != told.end()) continue;
      told.push_back(words);
      text += words;
    }
  if (told.empty()) text += "  memory and game only\n";
  return text;
}

}  // namespace sim::debug
