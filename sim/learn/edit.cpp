#include "sim/learn/edit.h"

#include <algorithm>
#include <cstdlib>
#include <set>
#include <utility>

#include "robot/core/json_library.h"
#include "sim/learn/rules.h"

namespace sim::learn {
namespace {

using io::Json;
using Pointer = Json::json_pointer;

Json action_of(const Json& rule) {
  Json action = {{"do", rule["do"]}};
  if (rule.contains("with")) action["with"] = rule["with"];
  return action;
}

void put_action(const Json& action, Json& rule) {
  rule["do"] = action["do"];
  rule.erase("with");
  if (action.contains("with")) rule["with"] = action["with"];
}

bool is_of(const Layer& layer, const Json& rule) {
  return rule.contains("do") && rule["do"].is_string() &&
         std::ranges::find(layer.leaves, rule["do"].get<std::string>()) != layer.leaves.end();
}

/// Returns the list that holds the rule at `pointer`, and its place in it. The list is nullptr if the rule is in no list.
std::pair<Json*, std::size_t> list_with(Json& strategy, const std::string& pointer) {
  const Pointer place(pointer);
  Json& parent = strategy.at(place.parent_pointer());
  if (!parent.is_array()) return {nullptr, 0};
  return {&parent, static_cast<std::size_t>(std::strtoull(place.back().c_str(), nullptr, 10))};
}

/// Collects the names that the rules use: "$name" and subtrees.
void collect(const Json& json, std::set<std::string>& parameters, std::set<std::string>& subtrees) {
  if (json.is_string()) {
    const auto& text = json.get_ref<const std::string&>();
    for (std::size_t at = text.find('$'); at != text.npos; at = text.find('$', at + 1)) {
      const std::size_t end =
          text.find_first_not_of("abcdefghijklmnopqrstuvwxyzABCDEFGHIJKLMNOPQRSTUVWXYZ0123456789_", at + 1);
      parameters.insert(text.substr(at + 1, end == text.npos ? end : end - at - 1));
    }
  }
  if (json.is_object())
    if (const auto use = json.find("use"); use != json.end() && use->is_string())
      subtrees.insert(use->get<std::string>());
  if (json.is_structured())
    for (const auto& part : json) collect(part, parameters, subtrees);
}

void keep_only(const std::set<std::string>& used, Json& section) {
  Json kept = Json::object();
  for (const auto& [name, value] : section.items())
    if (used.contains(name)) kept[name] = value;
  section = std::move(kept);
}

}  // namespace

std::vector<LeafRule> leaves_of(const Json& strategy, const Layer& layer) {
  std::vector<LeafRule> leaves;
  for_each_rule(strategy, [&](const RulePlace& place, const Json& rule) {
    if (!is_of(layer, rule)) return;
    LeafRule leaf{place.pointer, place.name, action_of(rule), {}};
    if (rule.contains("learn"))
      for (const Json& action : rule["learn"]) leaf.alternatives.push_back(action_of(action));
    else
      for (const std::string& action : layer.actions) leaf.alternatives.push_back(Json::parse(action));
    std::erase(leaf.alternatives, leaf.action);
    leaves.push_back(std::move(leaf));
  });
  return leaves;
}

Json with_action(Json strategy, const std::string& pointer, const Json& action) {
  put_action(action, strategy.at(Pointer(pointer)));
  return without_unused(std::move(strategy));
}

Json with_split(Json strategy, const std::string& pointer, const std::string& condition, const Json& action) {
  Json& rule = strategy.at(Pointer(pointer));
  // the name must stay true when the threshold is tuned
  const std::string feature = condition.substr(0, condition.find(' '));
  Json added = {{"name", name_of_rule(rule) + ", by " + feature}, {"if", condition}};
  put_action(action, added);
  if (rule.contains("if")) {
    // the new rule stands within the condition of the old one
    Json inner = action_of(rule), outer = Json::object();
    if (rule.contains("learn")) inner["learn"] = rule["learn"];
    for (const char* key : {"name", "about", "if"})
      if (rule.contains(key)) outer[key] = rule[key];
    outer["then"] = Json::array({std::move(added), std::move(inner)});
    if (rule.contains("else")) outer["else"] = rule["else"];
    rule = std::move(outer);
    return strategy;
  }
  const auto [list, place] = list_with(strategy, pointer);
  if (list)
    list->insert(list->begin() + static_cast<std::ptrdiff_t>(place), std::move(added));
  else
    rule = Json::array({std::move(added), Json(rule)});
  return strategy;
}

std::vector<SpareRule> spare_rules(const Json& strategy, const Layer& layer) {
  std::vector<SpareRule> spare;
  Json copy = strategy;
  for_each_rule(strategy, [&](const RulePlace& place, const Json& rule) {
    if (!is_of(layer, rule) || !rule.contains("if") || rule.contains("else")) return;
    const auto [list, at] = list_with(copy, place.pointer);
    if (list && at + 1 < list->size()) spare.push_back({place.pointer, place.name});
  });
  return spare;
}

Json without_rule(Json strategy, const std::string& pointer) {
  const auto [list, place] = list_with(strategy, pointer);
  if (list) list->erase(place);
  return without_unused(std::move(strategy));
}

Json without_unused(Json strategy) {
  // a subtree that goes may have been the only user of another
  for (std::size_t before = 0, now = 1; before != now;) {
    std::set<std::string> parameters, subtrees;
    for (const char* section : {"tree", "subtrees"})
      if (strategy.contains(section)) collect(strategy[section], parameters, subtrees);
    before = strategy.dump().size();
    if (strategy.contains("parameters")) keep_only(parameters, strategy["parameters"]);
    if (strategy.contains("subtrees")) keep_only(subtrees, strategy["subtrees"]);
    now = strategy.dump().size();
  }
  return strategy;
}

std::string words_of(const Json& action) {
  std::string words = action["do"].get<std::string>();
  if (!action.contains("with") || action["with"].empty()) return words;
  const char* separator = " (";
  for (const auto& [key, value] : action["with"].items()) {
    words += separator + key + " " + (value.is_string() ? value.get<std::string>() : value.dump());
    separator = ", ";
  }
  return words + ")";
}

}  // namespace sim::learn
