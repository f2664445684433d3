#include "sim/io/strategy_tree.h"

#include <set>
#include <vector>

#include "robot/core/json_library.h"
#include "sim/io/condition.h"
#include "sim/io/values.h"
#include "sim/io/vocabulary.h"
#include "sim/io/words.h"

namespace sim::io {
namespace {

std::string got_both(const std::string& one, const std::string& other) {
  return "takes '" + one + "' or '" + other + "', got both";
}

using agent::Skill;
using agent::SkillInfo;
using robot::Result;

constexpr int kMaxDepth = 48;  // nested rules, subtrees included
constexpr std::string_view kKeys[] = {"name", "about", "if", "then", "else", "do", "with", "use"};

/// The target when a condition fails and the rule has no "else".
struct Next {
  std::uint16_t target = 0;
  bool exists = false;
  bool used = false;
};

/// The place of a rule.
struct Place {
  std::string json;   // "tree[2].then": for error sentences
  std::string names;  // "baseline/ball known": for the trace
  int depth = 0;

  Place at(const std::string& more) const { return {json + more, names, depth + 1}; }
  Place named(std::string_view name) const { return {json, names + "/" + std::string(name), depth}; }
};

const Json kNothing = Json::object();

const Json& object_at(const Json& json, const char* key) {
  const auto found = json.find(key);
  return found != json.end() && found->is_object() ? *found : kNothing;
}

class Compiler {
 public:
  Compiler(const Json& strategy, agent::Tree& tree)
      : tree_(tree), subtrees_(object_at(strategy, "subtrees")), values_(object_at(strategy, "parameters")) {}

  std::string compile(const Json& strategy, const Json& own) {
    const auto root = strategy.find("tree");
    if (root == strategy.end()) return "tree is missing";
    Next nothing;
    tree_.root = rules(*root, {"tree", tree_.name, 0}, nothing);
    refuse_unused(own);
    return problem_;
  }

  std::string compile_menu(const Json& strategy, const Json& own) {
    const auto menu = strategy.find("menu");
    if (menu == strategy.end()) return "menu is missing";
    if (!menu->is_array() || menu->empty() || menu->size() > agent::kMaxMenu)
      return "menu must be a list of 1 .. " + std::to_string(agent::kMaxMenu) + " rules, got " + shown(*menu);
    for (std::size_t i = 0; i < menu->size() && problem_.empty(); ++i) {
      Next nothing;
      tree_.menu.push_back(rules((*menu)[i], {"menu[" + std::to_string(i) + "]", tree_.name, 0}, nothing));
    }
    if (problem_.empty()) refuse_unused(own);
    return problem_;
  }

 private:
  void refuse(const Place& place, const std::string& what) {
    if (problem_.empty()) problem_ = place.json + ": " + what;
  }

  /// Compiles a rule or a list of rules. Returns its entry.
  std::uint16_t rules(const Json& json, const Place& place, Next& next) {
    if (!problem_.empty()) return 0;
    if (place.depth > kMaxDepth) return refuse(place, "rules are nested too deeply"), std::uint16_t{0};
    if (json.is_object()) return rule(json, place, next);
    if (json.is_array()) return list(json, place, next);
    return refuse(place, "must be a rule or a list of rules, got " + shown(json)), std::uint16_t{0};
  }

  /// Compiles a list from the last rule to the first, because each needs the entry of the next.
  std::uint16_t list(const Json& json, const Place& place, Next& next) {
    if (json.empty()) return refuse(place, "must have at least one rule"), std::uint16_t{0};
    Next behind = next;
    for (std::size_t i = json.size(); i-- > 0;) {
      const bool last = i + 1 == json.size();
      behind.used = false;
      const std::uint16_t entry = rules(json[i], place.at("[" + std::to_string(i) + "]"), behind);
      if (!problem_.empty()) return 0;
      if (last)
        next.used |= behind.used;
      else if (!behind.used)
        return refuse(place.at("[" + std::to_string(i + 1) + "]"), "is never reached, the rule before always decides"),
               std::uint16_t{0};
      behind = {entry, true, false};
    }
    return behind.target;
  }

  std::uint16_t rule(const Json& json, const Place& place, Next& next) {
    if (!check_keys(json, place)) return 0;
    const auto condition = json.find("if");
    if (condition == json.end()) return body(json, named(json, place), next);
    if (!condition->is_string())
      return refuse(place.at(".if"), "must be a text, got " + shown(*condition)), std::uint16_t{0};
    const std::string& text = condition->get_ref<const std::string&>();
    const Result<Condition> parsed = parse_condition(text, values_);
    if (!parsed) return refuse(place.at(".if"), parsed.error()), std::uint16_t{0};

    const Place here = json.contains("name") ? named(json, place) : place.named(text);
    const std::uint16_t yes = body(json, here, next);
    const auto otherwise = json.find("else");
    std::uint16_t no = next.target;
    if (otherwise != json.end())
      no = rules(*otherwise, place.at(".else"), next);
    else if (!next.exists)
      refuse(place, "has no 'else', and no later rule applies when '" + text + "' fails");
    else
      next.used = true;
    if (!problem_.empty()) return 0;
    return comparisons(*parsed, here, yes, no);
  }

  bool check_keys(const Json& json, const Place& place) {
    const std::vector<std::string_view> known(std::begin(kKeys), std::end(kKeys));
    for (const auto& [key, value] : json.items())
      if (std::find(known.begin(), known.end(), key) == known.end())
        return refuse(place, "no rule has '" + key + "'" + hint(key, known)), false;
    for (const char* key : {"name", "about"})
      if (json.contains(key) && !json[key].is_string())
        return refuse(place.at("." + std::string(key)), "must be a text, got " + shown(json[key])), false;
    if (json.contains("do") + json.contains("use") + json.contains("then") != 1)
      return refuse(place, "must have one of 'do', 'use' and 'then'"), false;
    if (!json.contains("if") && (json.contains("then") || json.contains("else")))
      return refuse(place, "has 'then' or 'else' without 'if'"), false;
    if (json.contains("with") && !json.contains("do")) return refuse(place, "has 'with' without 'do'"), false;
    return true;
  }

  Place named(const Json& json, const Place& place) {
    return json.contains("name") ? place.named(json["name"].get_ref<const std::string&>()) : place;
  }

  /// Compiles the part of a rule for a condition that holds.
  std::uint16_t body(const Json& json, const Place& place, Next& next) {
    if (!problem_.empty()) return 0;
    if (json.contains("then")) return rules(json["then"], place.at(".then"), next);
    if (json.contains("use")) return use(json["use"], place, next);
    return leaf(json, place);
  }

  std::uint16_t use(const Json& name, const Place& place, Next& next) {
    if (!name.is_string()) return refuse(place.at(".use"), "must be a text, got " + shown(name)), std::uint16_t{0};
    const std::string& subtree = name.get_ref<const std::string&>();
    const auto found = subtrees_.find(subtree);
    if (found == subtrees_.end()) {
      std::vector<std::string_view> known;
      for (const auto& [key, value] : subtrees_.items()) known.emplace_back(key);
      return refuse(place.at(".use"), "no subtree '" + subtree + "'" + hint(subtree, known)), std::uint16_t{0};
    }
    for (const std::string& open : open_)
      if (open == subtree)
        return refuse(place.at(".use"), "the subtree '" + subtree + "' leads back to itself"), std::uint16_t{0};
    used_.insert(subtree);
    open_.push_back(subtree);
    Place inside = place.named(subtree);
    inside.json = "subtrees." + subtree, inside.depth += 1;
    const std::uint16_t entry = rules(*found, inside, next);
    open_.pop_back();
    return entry;
  }

  std::uint16_t leaf(const Json& json, const Place& place) {
    const Json& name = json["do"];
    if (!name.is_string()) return refuse(place.at(".do"), "must be a text, got " + shown(name)), std::uint16_t{0};
    const Result<Skill> skill = skill_named(name.get_ref<const std::string&>());
    if (!skill) return refuse(place.at(".do"), skill.error()), std::uint16_t{0};
    const SkillInfo& info = info_of(*skill);
    agent::Leaf made{.skill = *skill};
    read_arguments(json.contains("with") ? json["with"] : kNothing, info, place.at(".with"), made);
    if (!problem_.empty()) return 0;
    if (tree_.leaves.size() == agent::kMaxLeaves) return refuse(place, "the tree is too large"), std::uint16_t{0};
    tree_.leaves.push_back(made);
    tree_.leaf_words.push_back({place.names + "/" + info.name, info.name, ""});
    return static_cast<std::uint16_t>((tree_.leaves.size() - 1) | agent::kLeafBit);
  }

  void read_arguments(const Json& with, const SkillInfo& skill, const Place& place, agent::Leaf& leaf) {
    if (!with.is_object()) return refuse(place, "must be an object, got " + shown(with));
    std::vector<std::string_view> known;
    std::string chosen;  // the given one of the alternatives
    for (int i = 0; i < skill.count; ++i) {
      const agent::ParameterInfo& info = skill.parameters[i];
      const std::string key = info.key();
      known.emplace_back(info.key());
      leaf.arguments[i] = info.standard;
      const auto given = with.find(key);
      if (given == with.end()) continue;
      if (info.range.alternative && !chosen.empty() && chosen != key) return refuse(place, got_both(chosen, key));
      if (info.range.alternative) chosen = key;
      const bool is_point = given->is_array() && given->size() == 2;
      if (info.range.point && !is_point)
        return refuse(place.at("." + key), "must be a point [x, y] in m, got " + shown(*given));
      const Json& value = info.range.point ? (*given)[static_cast<std::size_t>(info.range.coordinate)] : *given;
      const Result<float> read = values_.read(value, expected_of(info, &tree_.settings.kicks));
      if (!read) return refuse(place.at("." + std::string(info.name)), read.error());
      leaf.arguments[i] = *read;
    }
    for (const auto& [key, value] : with.items())
      if (std::find(known.begin(), known.end(), key) == known.end())
        return refuse(place, std::string(skill.name) + " takes no '" + key + "'" + hint(key, known));
  }

  /// Compiles all alternatives and their terms, from the last to the first.
  std::uint16_t comparisons(const Condition& condition, const Place& place, std::uint16_t yes, std::uint16_t no) {
    std::uint16_t entry = no;
    for (auto terms = condition.alternatives.rbegin(); terms != condition.alternatives.rend(); ++terms) {
      const std::uint16_t fails = entry;
      entry = yes;
      for (auto term = terms->rbegin(); term != terms->rend(); ++term) {
        if (tree_.nodes.size() == agent::kMaxNodes) return refuse(place, "the tree is too large"), std::uint16_t{0};
        tree_.nodes.push_back({term->feature, term->comparison, entry, fails, term->threshold, term->other});
        tree_.node_words.push_back({place.names, place.names.substr(place.names.rfind('/') + 1), term->text});
        entry = static_cast<std::uint16_t>(tree_.nodes.size() - 1);
      }
    }
    return entry;
  }

  void refuse_unused(const Json& own) {
    const auto check = [&](const char* section, const std::set<std::string, std::less<>>& used) {
      for (const auto& [key, value] : object_at(own, section).items())
        if (!used.contains(key))
          refuse({std::string(section) + "." + key, ""}, "is not used" + did_you_mean(key, {used.begin(), used.end()}));
    };
    check("subtrees", used_);
    check("parameters", values_.used());
  }

  agent::Tree& tree_;
  const Json& subtrees_;
  Values values_;
  std::vector<std::string> open_;  // subtrees being compiled
  std::set<std::string, std::less<>> used_;
  std::string problem_;
};

}  // namespace

std::string compile_tree(const Json& strategy, const Json& own, agent::Tree& tree) {
  return Compiler(strategy, tree).compile(strategy, own);
}

std::string compile_menu(const Json& strategy, const Json& own, agent::Tree& tree) {
  return Compiler(strategy, tree).compile_menu(strategy, own);
}

}  // namespace sim::io
