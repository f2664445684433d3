#include "sim/io/playbook.h"

#include <algorithm>
#include <numeric>

#include "sim/io/matchup.h"
#include "sim/io/outlook.h"
#include "sim/io/strategy.h"

namespace sim::io {

using robot::Error;
using robot::Result;

Result<Playbook> prepare_playbook(const PlaybookChoice& choice) {
  const std::size_t count = choice.strategies.size();
  if (count < 1 || count > foresight::kMaxStrategies)
    return Error{"strategies must be 1 .. " + std::to_string(foresight::kMaxStrategies) + ", got " +
                 std::to_string(count)};
  for (auto name = choice.strategies.begin(); name != choice.strategies.end(); ++name)
    if (std::find(choice.strategies.begin(), name, *name) != name)
      return Error{"strategies must differ, '" + *name + "' occurs twice"};

  const auto own = static_cast<std::size_t>(choice.own), others = 1 - own;
  // the opponents play a tree: an opponent that chooses too would have to simulate our choice
  if (const auto opponent = load_strategy(choice.opponent); !opponent) return opponent.failure();
  Matchup game{.rules = choice.rules, .players = choice.players, .pace = choice.pace};
  game.strategies[own] = choice.strategies.front();
  game.strategies[others] = choice.opponent;
  game.models[own] = choice.models;
  game.models[others] = choice.opponent_models;
  const Result<PreparedGame> setup = prepare(game);
  if (!setup) return setup.failure();
  const Result<foresight::Outlook> outlook = load_outlook(choice.rules);
  if (!outlook) return outlook.failure();

  Playbook playbook{.choice = choice, .params = {}, .outlook = *outlook, .behaviours = {}};
  for (const std::string& name : choice.strategies) {
    auto behaviour = load_strategy(name);
    if (!behaviour) return behaviour.failure();
    if (auto checked = check_kicks((*behaviour)->tree(), setup->params.teams[own]); !checked) return checked.failure();
    playbook.params.push_back(setup->params);
    playbook.params.back().teams[own].behaviour = behaviour->get();
    playbook.behaviours.push_back(std::move(*behaviour));
  }
  playbook.behaviours.push_back(setup->behaviours[others]);
  return playbook;
}

foresight::Task task_of(const Playbook& playbook, const std::vector<int>& strategies,
                        const foresight::Situation& situation, const foresight::Question& question, RandomKey key) {
  foresight::Task task{.situation = &situation, .question = question, .outlook = &playbook.outlook, .key = key};
  task.question.own = playbook.choice.own;
  for (const int strategy : strategies)
    task.params[task.strategies++] = &playbook.params[static_cast<std::size_t>(strategy)];
  return task;
}

foresight::Task task_of(const Playbook& playbook, const foresight::Situation& situation,
                        const foresight::Question& question, RandomKey key) {
  std::vector<int> all(playbook.params.size());
  std::iota(all.begin(), all.end(), 0);
  return task_of(playbook, all, situation, question, key);
}

}  // namespace sim::io
