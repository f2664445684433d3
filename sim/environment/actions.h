// The actions of an agent: a row of numbers, which holds until the next step.
//
//   menu    1 number: a rule of the frame's menu, 0 .. rules - 1
//   skills  1 + kMaxArguments numbers: a skill of sim/agent/skills.h, and its arguments [SI] in the order of its parameters;
//           NaN: the argument's default. A direction or a point beats an aim.
//   motion  kMotionWidth numbers in [-1, 1], others are clipped:
//             forward, left, turn   share of the greatest speed
//             kick                  > 0.5 with the left foot, < -0.5 with the right one; the rest of the range is divided
//                                   equally between the kicks of the model, the first one next to 0.5
//             squat                 > 0.5: squats, unless it kicks
//             yaw, pitch            of the head, share of its limits; > 0: left, down
//
// Menus and skills keep the manners of every strategy (sim/agent/manners.h), motion does not. A robot decides at its own
// turns (sim/match/pace.h), so it may obey an action some ticks later, and several times with newer beliefs.
#pragma once

#include <cstdint>
#include <string>

#include "sim/agent/policy.h"
#include "sim/motion/command.h"
#include "sim/motion/model.h"

namespace sim::environment {

enum class Kind : std::uint8_t { menu, skills, motion };
inline constexpr const char* kKinds[] = {"menu", "skills", "motion"};  // by Kind

inline constexpr int kMotionWidth = 7;
inline constexpr const char* kMotionNames[kMotionWidth] = {"forward", "left", "turn", "kick", "squat", "yaw", "pitch"};

/// Returns the length of a row.
constexpr int width_of(Kind kind) {
  return kind == Kind::menu ? 1 : kind == Kind::skills ? 1 + agent::kMaxArguments : kMotionWidth;
}

/// Returns the problem of a row, the end of a sentence such as "must be a whole number 0 .. 11, got 12"; empty: there is
/// none. Allocates nothing then.
std::string problem_of(Kind kind, const agent::Tree& tree, const float* row);

/// Returns the command of an action without problem. `view` is prepared, and in play.
motion::Command obey(Kind kind, const agent::Tree& tree, const float* row, const agent::View& view, agent::Mind& mind);

/// Returns the command of a row of Kind::motion.
motion::Command command_of(const float* row, const motion::Model& model);

}  // namespace sim::environment
