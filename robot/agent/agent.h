// A robot's agent: beliefs in, motion command out.
#pragma once

#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "proto/foresight/agent.pb.h"
#include "proto/foresight/motion.pb.h"
#include "robot/bridge/from_messages.h"
#include "robot/core/result.h"
#include "sim/agent/behaviour.h"
#include "sim/agent/choice.h"
#include "sim/agent/mind.h"
#include "sim/agent/trace.h"
#include "sim/io/matchup.h"

namespace robot::agent {

namespace pb = ::foresight;

/// The names of an agent's behaviour, rules and models, as on the command line.
struct AgentChoice {
  std::string behaviour = "baseline";
  std::vector<std::string> strategies;  // that a captain may choose from, `behaviour` first; empty: only `behaviour`
  sim::Tick stale = 0;                  // [ticks] a captain that is silent for longer is no longer followed
  std::string rules = "spl2025", models = "match";
};

/// Loads a behaviour that follows the captain's choice among `strategies`, at least one, by name or path. It plays the
/// first one when the captain has been silent for `stale` [ticks]. Returns an Error that names
/// a strategy that cannot be loaded.
Result<std::shared_ptr<const sim::agent::Behaviour>> follower_of(const std::vector<std::string>& strategies,
                                                                 sim::Tick stale);

/// The memory of one agent between its decisions. The same recollections in the same order give the same commands.
/// No clock, no thread: times are given. Used by one thread at a time.
class Agent {
 public:
  /// Loads the behaviour, the rules and the models of the own body. Returns an Error that names the one that is wrong.
  static Result<Agent> load(const AgentChoice& choice);

  /// A decision. Without one the robot stands, and `problem` is the reason in one sentence.
  struct Decision {
    pb::MotionCommand command;
    std::optional<pb::DecisionTrace> trace;  // absent also when the behaviour gives no reasons
    std::string problem;                     // empty: the behaviour decided
  };

  /// Decides from the newest data of a moment. `recollection.now` is overwritten.
  Decision decide(bridge::Recollection recollection);

  /// Sets the strategy of the team, as a captain chose it. No effect when the agent has one behaviour only.
  void follow(const sim::agent::Choice& choice) { choice_ = choice; }

 private:
  explicit Agent(sim::io::PreparedGame game) : game_(std::move(game)) {}

  sim::Tick tick_of(std::uint64_t now_ns);

  sim::io::PreparedGame game_;
  sim::agent::Mind mind_;
  std::optional<sim::agent::Choice> choice_;
  std::optional<std::uint64_t> first_ns_;  // of the first decision
  std::uint64_t newest_ns_ = 0;
};

}  // namespace robot::agent
