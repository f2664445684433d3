// Skills and features of a team's own, which trees use like ours.
//
// One file each: sim/agent/own/NAME.cpp with a function NAME() that returns one of these, and NAME in the list in
// sim/agent/CMakeLists.txt. The two examples there are a skill, `shadow`, and a feature, `mates_ahead`. As everything
// that decides they are functions of their arguments, and compute with sim/math, so that every machine agrees.
#pragma once

#include <vector>

#include "sim/agent/features.h"
#include "sim/agent/skills.h"

namespace sim::agent {

struct OwnSkill {
  SkillInfo info;
  /// What it does now; `with` has the values of the parameters, in their order.
  motion::Command (*run)(const float* with, const View& view, Mind& mind);
};

struct OwnFeature {
  FeatureInfo info;
  /// The value [SI; 1 or 0 for yes or no], NaN where the robot does not know.
  float (*value)(const View& view);
};

/// In the order of the lists.
const std::vector<OwnSkill>& own_skills();
const std::vector<OwnFeature>& own_features();

}  // namespace sim::agent
