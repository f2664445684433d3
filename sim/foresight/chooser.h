// A team that chooses its strategy by foresight while it plays.
#pragma once

#include <memory>
#include <string>
#include <vector>

#include "sim/agent/behaviour.h"
#include "sim/agent/follower.h"
#include "sim/foresight/outlook.h"
#include "sim/foresight/question.h"
#include "sim/match/params.h"

namespace sim::foresight {

/// The strategies to choose from, and the assumed opponents.
struct Plans {
  std::vector<Params> params;  // by strategy, its own side at home; the first is the default
  Outlook outlook;
  /// By strategy, then others that the parameters point to.
  std::vector<std::shared_ptr<const agent::Behaviour>> behaviours;
};

/// The times and the size of its questions.
struct Terms {
  int rollouts = 64;   // per question, over all strategies
  float horizon = 20;  // [s] game time of a rollout
  float period = 10;   // [s] longest time between questions
  float stale = 20;    // [s] a choice unconfirmed for longer is not followed
  // Most changes matter little. A strategy that is usually worse is also worse in the moments where luck favours it.
  // Measured in 1000 moments of a team whose default is the best of its three, with 54 rollouts each. A change at a
  // certainty of 70 %, 80 % and 90 % cost 0.11, cost 0.08 and won 0.02 goals a game (standard errors 0.05, 0.04, 0.02).
  // Source: foresight-sim choosing --strategies high_line,baseline,kick_now. A change back is free.
  float switching_cost = 0;  // [goals] Question::switching_cost
  float sure = 0.9f;         // Question::sure

  template <class Self, class See>
  static void visit(Self& self, See&& see) {
    see("rollouts", self.rollouts, "", 8, 100'000);
    see("horizon", self.horizon, "s", 1.f, 1200.f);
    see("period", self.period, "s", 2.f, 1200.f);
    see("stale", self.stale, "s", 1.f, 1200.f);
    see("switching_cost", self.switching_cost, "goals", 0.f, 1.f);
    see("sure", self.sure, "", 0.5f, 0.999f);
  }
};

/// A team of followers whose captain chooses by rollouts from its own beliefs. A robot is the captain if it believes
/// so. All strategies are compared with the default, whichever is played now. Another strategy is played only as long
/// as each question finds it better with certainty. Questions are coarse: a wrong choice
/// that had to be disproved would stay.
///
/// The mind is its only memory. The random key of a question comes from the beliefs: a
/// game stays a function of its seed.
class Chooser final : public agent::Behaviour {
 public:
  /// The playbook has 2 .. kMaxStrategies strategies.
  Chooser(std::string name, Plans plans, const Terms& terms);

  const std::string& name() const override { return name_; }
  motion::Command decide(const agent::Surroundings& surroundings, const agent::Game& game,
                         const agent::Beliefs& beliefs, Tick now, agent::Mind& mind,
                         agent::Trace* trace) const override;

 private:
  bool has_reason(const agent::Game& game, const agent::Beliefs& beliefs, Tick now, const agent::Mind& mind) const;
  void ask(const agent::Game& game, const agent::Beliefs& beliefs, Tick now, agent::Mind& mind) const;

  const std::string name_;
  const Plans plans_;
  const Terms terms_;
  const agent::Follower team_;
};

}  // namespace sim::foresight
