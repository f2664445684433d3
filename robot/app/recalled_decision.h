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

  /// Returns the tree of that name, also an embedded one, which is then kept. The name comes from a client, so it is never
  /// a path.
  Result<Tree> named(const std::string& name);

 private:
  std::vector<Tree> trees_;
};

/// An explained decision.
struct RecalledDecision {
  sim::io::PreparedGame game;  // with the tree as the home side's behaviour
  KnownTrees::Tree tree;
  sim::debug::Why why;
  bool has_truth = false;  // otherwise `why` knows no truth
  bool agrees = false;     // the robot decided for the same leaf; the memory of its behaviour may differ
};

/// Makes the decision of `from` again and explains it, without the sources of its comparisons. `from.now_ns` is its capture
/// time. `truth` is that of the same moment; without the ball and the robot itself it is no help. `game` has the rules, and
/// the models of the home side are those of the robot. Returns an Error that names a missing object or an unknown tree.
Result<RecalledDecision> explain(const bridge::Recollection& from, const std::optional<foresight::GroundTruth>& truth,
                                 sim::io::PreparedGame game, KnownTrees& trees);

}  // namespace robot::app
