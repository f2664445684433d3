// What foresight chooses from, by name: the strategies of one side, against what the other is taken to play.
#pragma once

#include <memory>
#include <string>
#include <vector>

#include "robot/core/result.h"
#include "sim/foresight/race.h"
#include "sim/match/params.h"

namespace sim::io {

/// As one types it.
struct PlaybookChoice {
  std::vector<std::string> strategies;  // 1 .. foresight::kMaxStrategies different ones; the first is the incumbent
  std::string opponent = "baseline";    // what the others are taken to play
  std::string rules = "spl2012";
  std::string models = "match";           // of one's own robots
  std::string opponent_models = "match";  // of the others'
  int players = 0;                        // a side; 0: as the rules say
  Side own = Side::home;
  Pace pace = Pace::thinned;
};

/// Does not change; any number of races may use it at once.
struct Playbook {
  PlaybookChoice choice;
  std::vector<Params> params;  // by strategy
  foresight::Outlook outlook;
  std::vector<std::shared_ptr<const agent::Behaviour>>
      behaviours;  // that the parameters point to; the last is the others'

  const std::vector<std::string>& names() const { return choice.strategies; }
};

robot::Result<Playbook> prepare_playbook(const PlaybookChoice& choice);

/// A task that races these strategies of the playbook, by index, the first the incumbent; both outlive it.
foresight::Task task_of(const Playbook& playbook, const std::vector<int>& strategies,
                        const foresight::Situation& situation, const foresight::Question& question, RandomKey key);
/// The same for all of them.
foresight::Task task_of(const Playbook& playbook, const foresight::Situation& situation,
                        const foresight::Question& question, RandomKey key);

}  // namespace sim::io
