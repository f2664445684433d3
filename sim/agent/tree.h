// A decision tree, compiled: a flat array of comparisons and the leaves they lead to.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "sim/agent/behaviour.h"
#include "sim/agent/features.h"
#include "sim/agent/settings.h"
#include "sim/agent/skills.h"

namespace sim::agent {

/// Which of "less", "greater" and "equal" pass, a bit each.
enum class Comparison : std::uint8_t { less = 1, greater = 2, unequal = 3, equal = 4, at_most = 5, at_least = 6 };

/// Where a comparison leads: a node, or with this bit a leaf. Nodes lead to earlier ones only: a tree cannot be a circle.
inline constexpr std::uint16_t kLeafBit = 0x8000;
inline constexpr int kMaxNodes = 4096;
inline constexpr int kMaxLeaves = 4096;

struct Node {
  Feature feature;
  Comparison comparison;
  std::uint16_t yes;
  std::uint16_t no;
  float threshold;
};

struct Leaf {
  Skill skill{};  // the first of the table: stand
  float arguments[kMaxArguments] = {};
};

/// The words of a node or leaf, for the trace.
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
};

/// Whether a value passes; an unknown one (NaN) never does.
inline bool holds(Comparison comparison, float value, float threshold) {
  // no branch to be mispredicted
  const int is = (value < threshold) | (value > threshold) << 1 | (value == threshold) << 2;
  return (is & static_cast<int>(comparison)) != 0;
}

/// Plays a tree. In the phases before, between and after play it stands or goes to its place.
class TreeBehaviour final : public Behaviour {
 public:
  explicit TreeBehaviour(Tree tree);

  const std::string& name() const override { return tree_.name; }
  motion::Command decide(const Surroundings& surroundings, const Game& game, const Beliefs& beliefs, Tick now,
                         Mind& mind, Trace* trace) const override;
  const Tree& tree() const { return tree_; }

 private:
  Tree tree_;
  // where a decision begins that knows the ball or not, in each role: past the comparisons that this settles
  std::uint16_t entries_[2][4];
};

/// What is done outside play: stand; in the phase ready, go to one's place. nullptr trace as in Behaviour::decide.
motion::Command wait(const View& view, Mind& mind, Trace* trace);
/// The robot may play now.
constexpr bool plays(const Game& game) { return game.phase == Game::Phase::playing && !game.penalised; }

}  // namespace sim::agent
