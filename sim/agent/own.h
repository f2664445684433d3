// Skills and features of a team's own. Trees use them like ours.
//
// Each is one file, sim/agent/own/NAME.cpp, with a function NAME() that returns its row (a SkillInfo or a FeatureInfo).
// NAME is also in the list in sim/agent/CMakeLists.txt. The examples are a skill, `shadow`, and a feature,
// `mates_ahead`. They are functions of their arguments and compute with sim/math, so that
// every machine gets the same bits.
#pragma once

#include <vector>

#include "sim/agent/features.h"
#include "sim/agent/skills.h"

namespace sim::agent {

// rows in the order of the lists in CMakeLists.txt
const std::vector<SkillInfo>& own_skills();
const std::vector<FeatureInfo>& own_features();

}  // namespace sim::agent
