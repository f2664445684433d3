// What the signature's scenarios are made of: everything that is embedded.
#pragma once

#include <memory>
#include <vector>

#include "robot/core/result.h"
#include "sim/match/signature.h"

namespace sim::io {

struct AllIngredients {
  Ingredients lists;
  std::vector<std::shared_ptr<const agent::Behaviour>> behaviours;  // that the list points to
};

/// Rules, models and strategies by name, ascending.
robot::Result<AllIngredients> embedded_ingredients();

}  // namespace sim::io
