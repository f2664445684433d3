#include "sim/io/ingredients.h"

#include <string>

#include "sim/io/models.h"
#include "sim/io/rules.h"
#include "sim/io/source.h"
#include "sim/io/strategy.h"

namespace sim::io {

robot::Result<AllIngredients> embedded_ingredients() {
  AllIngredients all;
  for (const std::string_view name : names_of("rules")) {
    const auto rules = load_rules(std::string(name));
    if (!rules) return rules.failure();
    all.lists.rules.push_back(*rules);
  }
  for (const std::string_view name : names_of("models")) {
    auto models = load_models(std::string(name));
    if (!models) return models.failure();
    all.lists.models.push_back(std::move(*models));
  }
  for (const std::string_view name : names_of("strategies")) {
    auto behaviour = load_strategy(std::string(name));
    if (!behaviour) return behaviour.failure();
    all.behaviours.push_back(std::move(*behaviour));
    all.lists.behaviours.push_back(all.behaviours.back().get());
  }
  return all;
}

}  // namespace sim::io
