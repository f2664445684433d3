#include "sim/learn/rules.h"

#include "robot/core/json_library.h"

namespace sim::learn {
namespace {

using io::Json;
using See = std::function<void(const RulePlace&, const Json&)>;

void walk(const Json& json, const std::string& pointer, const std::string& above, const See& see) {
  if (json.is_array()) {
    for (std::size_t i = 0; i < json.size(); ++i) walk(json[i], pointer + "/" + std::to_string(i), above, see);
    return;
  }
  if (!json.is_object()) return;
  const std::string name = name_of_rule(json);
  const RulePlace place{pointer, above.empty() ? name : above + " / " + name};
  see(place, json);
  for (const char* branch : {"then", "else"})
    if (json.contains(branch)) walk(json[branch], pointer + "/" + branch, place.name, see);
}

}  // namespace

void for_each_rule(const Json& strategy, const See& see) {
  if (strategy.contains("tree")) walk(strategy["tree"], "/tree", "", see);
  if (!strategy.contains("subtrees")) return;
  for (const auto& [name, rules] : strategy["subtrees"].items())
    walk(rules, "/subtrees/" + pointer_token(name), name, see);
}

std::string name_of_rule(const Json& rule) {
  for (const char* key : {"name", "if", "do", "use"})
    if (const auto found = rule.find(key); found != rule.end() && found->is_string()) return found->get<std::string>();
  return "rule";
}

std::string pointer_token(const std::string& key) {
  std::string token;
  for (const char c : key) {
    if (c == '~') token += "~0";
    if (c == '/') token += "~1";
    if (c != '~' && c != '/') token += c;
  }
  return token;
}

}  // namespace sim::learn
