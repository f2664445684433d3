// The ingredients of the signature's scenarios: everything that is embedded.
#pragma once

#include <memory>
#include <vector>

#include "robot/core/result.h"
#include "sim/match/signature.h"

namespace sim::io {

struct AllIngredients {
  Ingredients lists;
  std::vector<std::shared_ptr<const agent::Behaviour>> behaviours;  // to which the list points
};

/// Loads rules, models and strategies by name, ascending.
robot::Result<AllIngredients> embedded_ingredients();

}  // namespace sim::io
