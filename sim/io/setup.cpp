#include "sim/io/setup.h"

#include "sim/io/chooser.h"
#include "sim/io/models.h"
#include "sim/io/rules.h"

namespace sim::io {

using robot::Error;
using robot::Result;

Result<Setup> prepare(const Choice& choice) {
  Setup setup;
  Result<field::Rules> rules = load_rules(choice.rules);
  if (!rules) return Error{rules.error()};
  setup.params.rules = *rules;
  if (choice.players < 0 || choice.players > kMaxPlayers)
    return Error{"players must be 1 .. " + std::to_string(kMaxPlayers) + " a side, got " +
                 std::to_string(choice.players)};
  if (choice.players > 0) setup.params.rules.players = choice.players;
  setup.params.marks = field::marks_of(rules->field);
  setup.params.pace = choice.pace;

  for (const int side : {0, 1}) {
    Result<Models> models = load_models(choice.models[side]);
    if (!models) return Error{models.error()};
    auto behaviour = load_behaviour(choice.strategies[side], choice, static_cast<Side>(side));
    if (!behaviour) return Error{behaviour.error()};
    setup.behaviours[side] = std::move(*behaviour);
    setup.params.teams[side] = {.behaviour = setup.behaviours[side].get(), .models = std::move(*models)};
  }
  return setup;
}

}  // namespace sim::io
