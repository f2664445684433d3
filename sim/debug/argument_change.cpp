#include "sim/debug/argument_change.h"

#include <algorithm>
#include <cstdint>
#include <vector>

#include "robot/core/text.h"
#include "sim/agent/skills.h"
#include "sim/debug/answers.h"
#include "sim/io/values.h"
#include "sim/io/words.h"
#include "sim/math/angles.h"

namespace sim::debug {

using agent::ParameterInfo, agent::SkillInfo;
using robot::Error, robot::Result;

namespace {

/// Returns a value as a strategy may write it. Angles are in degrees.
std::string text_of_value(const ParameterInfo& info, float value, agent::NamedKicks& kicks) {
  if (std::string_view(info.range.unit) == "rad")
    return robot::formatted("%.4g deg", static_cast<double>(kDegrees * value));
  return io::value_text(value, io::expected_of(info, &kicks));
}

/// Returns the place of the argument among those of the skill, or -1.
int place_of(const SkillInfo& skill, std::string_view argument) {
  for (int i = 0; i < skill.count; ++i)
    if (skill.parameters[i].name == argument) return i;
  return -1;
}

Error no_argument(const agent::Tree& tree, const Goal& leaves, const std::string& where, std::string_view argument) {
  std::vector<std::string_view> known;
  for (std::size_t leaf = 0; leaf < leaves.size(); ++leaf) {
    const SkillInfo& skill = info_of(tree.leaves[leaf].skill);
    for (int i = 0; leaves[leaf] && i < skill.count; ++i)
      if (std::ranges::find(known, skill.parameters[i].name) == known.end())
        known.emplace_back(skill.parameters[i].name);
  }
  return {"no leaf of '" + where + "' takes '" + std::string(argument) + "'" + io::hint(argument, known)};
}

}  // namespace

Result<agent::Tree> with_argument(agent::Tree tree, const std::string& where, std::string_view argument,
                                  std::string_view value) {
  const auto leaves = goal_of(where, tree);
  if (!leaves) return leaves.failure();
  bool any = false;
  for (std::size_t leaf = 0; leaf < leaves->size(); ++leaf) {
    const SkillInfo& skill = info_of(tree.leaves[leaf].skill);
    const int place = (*leaves)[leaf] ? place_of(skill, argument) : -1;
    if (place < 0) continue;
    const ParameterInfo& info = skill.parameters[place];
    const auto read = io::Values().read(value, io::expected_of(info, &tree.settings.kicks));
    if (!read) return Error{"the argument '" + std::string(argument) + "' " + read.error()};
    for (int i = 0; info.range.alternative && i < skill.count; ++i) {
      const ParameterInfo& other = skill.parameters[i];
      if (other.range.alternative && std::string_view(other.key()) != info.key())
        tree.leaves[leaf].arguments[i] = other.standard;
    }
    tree.leaves[leaf].arguments[place] = *read;
    any = true;
  }
  if (!any) return no_argument(tree, *leaves, where, argument);
  return tree;
}

std::vector<Argument> arguments_of(const agent::Tree& tree, std::size_t leaf) {
  std::vector<Argument> all;
  agent::NamedKicks kicks = tree.settings.kicks;
  const SkillInfo& skill = info_of(tree.leaves[leaf].skill);
  for (int i = 0; i < skill.count; ++i) {
    const float value = tree.leaves[leaf].arguments[i];
    const ParameterInfo& info = skill.parameters[i];
    if (agent::is_given(value)) all.push_back({info.name, text_of_value(info, value, kicks)});
  }
  return all;
}

std::string leaves_text(const agent::Tree& tree) {
  std::string text;
  for (std::size_t leaf = tree.leaves.size(); leaf-- > 0;) {
    std::string arguments;
    for (const auto& [name, value] : arguments_of(tree, leaf))
      arguments.append(arguments.empty() ? "" : ", ").append(name).append(" ").append(value);
    text += robot::formatted("%-44s %s\n", tree.leaf_words[leaf].path.c_str(), arguments.c_str());
  }
  return text;
}

}  // namespace sim::debug
