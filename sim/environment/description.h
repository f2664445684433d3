// The description of an environment as JSON, for programs in other languages.
#pragma once

#include <string>
#include <vector>

#include "sim/environment/options.h"

namespace sim::environment {

/// Returns the name of an agent: "home_2".
std::string name_of_agent(int robot);

/// Returns agents, columns and actions as JSON, in the order of the arrays.
std::string description_of(const Options& options, const std::vector<int>& agents);

}  // namespace sim::environment
