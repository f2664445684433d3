// A robot's decision, made again from what its memory held: live, played, or sent by a client.
#pragma once

#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "proto/foresight/truth.pb.h"
#include "robot/bridge/from_messages.h"
#include "robot/core/result.h"
#include "sim/debug/why.h"
#include "sim/io/matchup.h"

namespace robot::app {

/// The trees of which decisions are explained.
class KnownTrees {
 public:
  using Tree = std::shared_ptr<const sim::agent::TreeBehaviour>;

  /// Loads the strategies of that name or path. One that cannot be loaded, or is no tree, is left out.
  explicit KnownTrees(const std::vector<std::string>& strategies);

  /// Returns the tree of that name, also an embedded one. The name comes from a client, so it is never a path.
  Result<Tree> named(const std::string& name) const;

 private:
  std::vector<Tree> trees_;
};

/// The game in which the robot decided.
struct RecalledGame {
  std::string rules;   // name, as on the command line
  std::string models;  // of the own body
};

/// An explained decision.
struct RecalledDecision {
  sim::io::PreparedGame game;  // with the tree as the home side's behaviour
  KnownTrees::Tree tree;
  sim::debug::Why why;
  bool has_truth = false;  // otherwise `why` knows no truth
  bool agrees = false;     // the robot decided for the same leaf; the memory of its behaviour may differ
};

/// Makes the decision of `from` again and explains it. `from.now_ns` is its capture time. `truth` is that of the same
/// moment; without the ball and the robot itself it is no help. Returns an Error that names a missing object, an unknown
/// tree or a wrong rule.
Result<RecalledDecision> explain(const bridge::Recollection& from, const std::optional<foresight::GroundTruth>& truth,
                                 const RecalledGame& game, const KnownTrees& trees);

}  // namespace robot::app
