// What a leaf of a tree can do: each skill turns a view and a few parameters into a command.
#pragma once

#include <cstdint>
#include <string_view>

#include "sim/agent/view.h"
#include "sim/motion/command.h"

namespace sim::agent {

enum class Skill : std::uint8_t {
  stand,
  search_ball,
  look_round,
  walk_to_ball,
  align,
  kick,
  dribble,
  pass,
  position,
  block,
  keep_goal,
  get_ready,
  count,
};
inline constexpr int kSkillCount = static_cast<int>(Skill::count);
/// What find_skill says of a name that it does not know.
inline constexpr Skill kNoSkill{255};
inline constexpr int kMaxArguments = 8;

/// One parameter of a skill.
struct ParameterInfo {
  const char* name;
  const char* unit;  // "" where there is none
  float least;       // in `unit`
  float most;
  float standard;            // where the tree says nothing
  bool lateral;              // changes its sign when left and right are exchanged
  const char* const* names;  // what the values 0.. are called, ended by nullptr; nullptr: it is a number
  const char* about;
};

struct SkillInfo {
  const char* name;
  const char* about;
  int count;  // of its parameters
  ParameterInfo parameters[kMaxArguments];
};
/// How many there are with those of a team's own (sim/agent/own.h), which follow ours: static_cast<Skill>(0 ..).
int skill_count();
const SkillInfo& info_of(Skill skill);
/// kNoSkill if there is none of that name.
Skill find_skill(std::string_view name);

/// What the skill does now. `arguments` are as many as the skill has parameters, in their order.
motion::Command run(Skill skill, const float* arguments, const View& view, Mind& mind);

}  // namespace sim::agent
