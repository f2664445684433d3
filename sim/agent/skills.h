// The skills that a leaf of a tree can name: each turns a view and a few arguments into a command.
//
// The table of skills is in skills.cpp, one row per skill. A skill's arguments are a struct that lists its parameters
// once: visit(self, see(name, member, range, about)). A member's initialiser is the value when the tree gives none.
#pragma once

#include <cstdint>
#include <string_view>
#include <type_traits>

#include "sim/agent/view.h"
#include "sim/motion/command.h"

namespace sim::agent {

inline constexpr int kMaxArguments = 12;

/// The values that a parameter may have.
struct Range {
  const char* unit;  // "" without a unit
  float least;       // in `unit`
  float most;
  bool lateral = false;                // the value changes its sign when left and right are exchanged
  const char* const* names = nullptr;  // the words for the values 0, 1, …, ended by nullptr; nullptr: a number
};
constexpr Range lateral_range(const char* unit, float most) { return {unit, -most, most, true}; }
inline constexpr Range kGainRange{"", 0.1f, 1};  // share of the greatest speed

/// One parameter of a skill.
struct ParameterInfo {
  const char* name;
  Range range;
  float standard;  // when the tree gives no value
  const char* about;
};

/// One row of the table of skills. The arguments of a leaf are in the order of `parameters`.
struct SkillInfo {
  const char* name;
  const char* about;
  motion::Command (*run)(const float* arguments, const View& view, Mind& mind);
  bool searches = false;  // a search goes on while a leaf has this skill; every other skill ends it (Mind.search_since)
  int count = 0;          // of its parameters
  ParameterInfo parameters[kMaxArguments] = {};
};

/// The arguments of a skill without parameters.
struct NoArguments {
  template <class Self, class See>
  static constexpr void visit(Self&, See&&) {}
};

/// Makes the row of a skill from its arguments' list of parameters and its function.
template <class Arguments, motion::Command (*Function)(const View&, Mind&, const Arguments&)>
constexpr SkillInfo skill(const char* name, const char* about) {
  SkillInfo row{.name = name, .about = about, .run = [](const float* values, const View& view, Mind& mind) {
                  Arguments arguments;
                  Arguments::visit(arguments, [&](const char*, auto& member, const Range&, const char*) {
                    // a number, or an enumeration by its number
                    using Member = std::remove_reference_t<decltype(member)>;
                    if constexpr (std::is_same_v<Member, float>)
                      member = *values;
                    else
                      member = static_cast<Member>(static_cast<int>(*values));
                    ++values;
                  });
                  return Function(view, mind, arguments);
                }};
  const Arguments standard;
  Arguments::visit(standard, [&](const char* parameter, const auto& member, const Range& range, const char* text) {
    row.parameters[row.count++] = {parameter, range, static_cast<float>(member), text};
  });
  return row;
}

/// The number of a skill: its row in the table, ours first, then the team's own (sim/agent/own.h).
enum class Skill : std::uint8_t {};
/// The answer of find_skill to an unknown name.
inline constexpr Skill kNoSkill{255};

/// Returns the number of skills, the team's own included: they are 0 .. skill_count() - 1.
int skill_count();
/// Returns the number of skills without the team's own.
int built_in_skill_count();
const SkillInfo& info_of(Skill skill);
/// Returns the skill of that name, or kNoSkill.
Skill find_skill(std::string_view name);

}  // namespace sim::agent
