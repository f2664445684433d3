#include "sim/io/matchup.h"

#include "sim/io/chooser.h"
#include "sim/io/models.h"
#include "sim/io/rules.h"

namespace sim::io {

using robot::Error;
using robot::Result;

Result<PreparedGame> prepare(const Matchup& matchup) {
  PreparedGame game;
  Result<field::Rules> rules = load_rules(matchup.rules);
  if (!rules) return rules.failure();
  game.params.rules = *rules;
  if (matchup.players < 0 || matchup.players > kMaxPlayers)
    return Error{"players must be 1 .. " + std::to_string(kMaxPlayers) + " a side, got " +
                 std::to_string(matchup.players)};
  if (matchup.players > 0) game.params.rules.players = matchup.players;
  game.params.marks = field::marks_of(rules->field);
  game.params.pace = matchup.pace;

  for (const int side : {0, 1}) {
    Team& team = game.params.teams[side];
    if (auto loaded = load_team_models(matchup.models[side], game.params.rules.players, team); !loaded)
      return loaded.failure();
    auto behaviour = load_behaviour(matchup.strategies[side], matchup, static_cast<Side>(side));
    if (!behaviour) return behaviour.failure();
    game.behaviours[side] = std::move(*behaviour);
    team.behaviour = game.behaviours[side].get();
  }
  take_ball_of_rules(game.params);
  return game;
}

}  // namespace sim::io
