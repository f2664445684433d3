// The strategies from which foresight chooses, by name, and the assumed opponents.
#pragma once

#include <memory>
#include <string>
#include <vector>

#include "robot/core/result.h"
#include "sim/foresight/race.h"
#include "sim/match/params.h"

namespace sim::io {

/// A playbook as typed.
struct PlaybookChoice {
  std::vector<std::string> strategies;  // 1 .. foresight::kMaxStrategies different ones; the first is the incumbent
  std::string opponent = "baseline";    // assumed strategy of the opponents
  std::string rules = "spl2012";
  std::string models = "match";           // of the own robots
  std::string opponent_models = "match";  // of the opponents' robots
  int players = 0;                        // per side; 0: by the rules
  Side own = Side::home;
  Pace pace = Pace::thinned;
};

/// The loaded playbook. Immutable: any number of races may share it.
struct Playbook {
  PlaybookChoice choice;
  std::vector<Params> params;  // by strategy
  foresight::Outlook outlook;
  std::vector<std::shared_ptr<const agent::Behaviour>>
      behaviours;  // to which the parameters point; the last is the opponents'

  const std::vector<std::string>& names() const { return choice.strategies; }
};

robot::Result<Playbook> prepare_playbook(const PlaybookChoice& choice);

/// Makes a task that races these strategies of the playbook, by index; the first is the incumbent. Playbook and
/// situation outlive the task.
foresight::Task task_of(const Playbook& playbook, const std::vector<int>& strategies,
                        const foresight::Situation& situation, const foresight::Question& question, RandomKey key);
/// Makes the task for all strategies.
foresight::Task task_of(const Playbook& playbook, const foresight::Situation& situation,
                        const foresight::Question& question, RandomKey key);

}  // namespace sim::io
