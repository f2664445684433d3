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

/// What it chooses from, and what it takes the others to be.
struct Plans {
  std::vector<Params> params;  // by strategy, its own side at home; the first is the default
  Outlook outlook;
  std::vector<std::shared_ptr<const agent::Behaviour>>
      behaviours;  // by strategy, then what else the parameters point to
};

/// When it asks, and how.
struct Terms {
  int rollouts = 64;   // for a question, all strategies together
  float horizon = 20;  // [s] of game time that each looks ahead
  float period = 10;   // [s] from one question to the next, at most
  float stale = 20;    // [s] a choice that was not confirmed for longer is not followed
  // Most changes matter little, and a strategy that is worse in most moments is worse in those that luck made look good:
  // of 1000 moments of a team whose default is the best of its three, with 54 futures each, what is better for 70 %, 80 %,
  // 90 % sure cost 0.11, cost 0.08 and won 0.02 goals a game, with standard errors of 0.05, 0.04 and 0.02
  // (foresight-sim choosing --strategies high_line,baseline,kick_now). A change back is free.
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

/// A team of followers, of whom the captain, as it believes that it is, asks what its strategies would come to, from its
/// own beliefs, and chooses. All are compared with the default, whatever is played now: another one is played only as
/// long as each question finds it better for sure. What a question can tell apart is coarse, and a wrong choice would
/// stay if it had to be proved wrong.
///
/// Remembers in the mind alone, and asks with a random key made of its beliefs: a game stays a function of its seed.
class Chooser final : public agent::Behaviour {
 public:
  /// 2 .. kMaxStrategies strategies.
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
