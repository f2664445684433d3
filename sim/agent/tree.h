// A compiled decision tree: flat arrays of comparisons and leaves.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "sim/agent/behaviour.h"
#include "sim/agent/features.h"
#include "sim/agent/settings.h"
#include "sim/agent/skills.h"

namespace sim::agent {

/// A comparison: one bit each for "less", "greater" and "equal" to pass.
enum class Comparison : std::uint8_t { less = 1, greater = 2, unequal = 3, equal = 4, at_most = 5, at_least = 6 };

/// Marks the target of a comparison as a leaf. A target without it is a node with a lower number: a tree has no cycles.
inline constexpr std::uint16_t kLeafBit = 0x8000;
inline constexpr int kMaxNodes = 4096;
inline constexpr int kMaxLeaves = 4096;
inline constexpr int kMaxMenu = 64;

struct Node {
  Feature feature;
  Comparison comparison;
  std::uint16_t yes;
  std::uint16_t no;
  float threshold;             // [SI] compared with the feature
  Feature other = kNoFeature;  // unless kNoFeature: compared with the feature instead of `threshold`
};

struct Leaf {
  Skill skill{};  // the first of the table: stand
  float arguments[kMaxArguments] = {};
};

/// The texts of a node or leaf, for the trace.
struct Words {
  std::string path;
  std::string name;
  std::string condition;
};

struct Tree {
  std::string name;
  std::string about;
  Settings settings;
  std::vector<Node> nodes;
  std::vector<Leaf> leaves;
  std::vector<Words> node_words;
  std::vector<Words> leaf_words;
  std::uint16_t root = kLeafBit;
  // the first nodes, or leaves, of the rules between which a policy chooses (sim/agent/policy.h); empty in a decision tree
  std::vector<std::uint16_t> menu;
};

/// Returns the comparison that passes all known values that `comparison` does not.
constexpr Comparison negated(Comparison comparison) {
  return static_cast<Comparison>(7 ^ static_cast<int>(comparison));
}

/// Returns whether a value passes. An unknown value or threshold (NaN) never passes.
inline bool holds(Comparison comparison, float value, float threshold) {
  // without branches, which would be mispredicted: 0 unknown, 1 less, 2 greater, 3 equal
  const int is = (value <= threshold) | (value >= threshold) << 1;
  return (static_cast<int>(comparison) << 1 >> is & 1) != 0;
}

/// The behaviour of a tree. Outside play the robot stands or goes to its place.
class TreeBehaviour final : public Behaviour {
 public:
  explicit TreeBehaviour(Tree tree);

  const std::string& name() const override { return tree_.name; }
  motion::Command decide(const Surroundings& surroundings, const Game& game, const Beliefs& beliefs, Tick now,
                         Mind& mind, Trace* trace) const override;
  const Tree& tree() const { return tree_; }

 private:
  Tree tree_;
  // first node of a decision, by ball known or not and by role: comparisons that these decide are skipped
  std::uint16_t entries_[2][4];
};

/// Does what a decision in play does before its first comparison: remembers the ball, and assigns the own role if that
/// is due. Features are computed after it.
void prepare(const View& view, Mind& mind);

/// Returns the number of the leaf to which the tree goes from its root. `view` is prepared.
std::uint16_t leaf_of(const Tree& tree, const View& view);

/// Returns the number of the leaf to which the tree goes from `entry`, a node or a leaf. `view` is prepared.
std::uint16_t leaf_from(const Tree& tree, std::uint16_t entry, const View& view);

/// Remembers the leaf and runs its skill. `view` is prepared. `trace` receives the leaf, or is nullptr.
motion::Command play_leaf(const Tree& tree, std::uint16_t number, const View& view, Mind& mind, Trace* trace);

/// Decides outside play: the robot stands, or goes to its place in the phase ready. `trace` may be nullptr.
motion::Command wait(const View& view, Mind& mind, Trace* trace);
/// Returns whether the robot may play now.
constexpr bool plays(const Game& game) { return game.phase == Game::Phase::playing && !game.penalised; }

}  // namespace sim::agent
