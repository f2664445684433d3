// Why did a robot decide so? The path through its tree, with the margin of every comparison on it.
//
// The law: with the threshold of one comparison changed as reported, the tree goes on at the promised branch and reaches
// the promised leaf. With its value changed by the reported margin, the comparison answers otherwise, and the tree
// reaches the promised leaf.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "sim/debug/flip.h"
#include "sim/debug/truth.h"

namespace sim::debug {

/// One comparison on the path.
struct Reason {
  std::uint16_t node = 0;  // number in the tree
  Answer answer;
  float truth = 0;                 // [SI] value of the feature if the robot knew everything; NaN: unknown even then
  Flip flip;                       // of `answer`
  float margin = 0;                // [SI] flip.value - answer.value; NaN: unknown, or no other value flips it
  std::uint16_t branch = 0;        // node or leaf (kLeafBit) at which the tree goes on after a flip
  std::uint16_t by_value = 0;      // leaf that the flipped value reaches: all comparisons use it. Only if there is one
  std::uint16_t by_threshold = 0;  // leaf that the flipped threshold reaches. Only if there is one
  std::vector<Source> sources;     // parts of the beliefs behind the value
};

/// The reasons of a decision.
struct Why {
  Decision decision;
  State state;         // at the tick of the decision
  bool plays = false;  // false: penalised or outside play, and the tree was not asked
  std::string skill;   // also outside play
  std::string role;
  std::uint16_t leaf = 0;    // number; only in play
  std::vector<Reason> path;  // from the root
  Evaluation evaluation;     // of the whole tree; only in play
  // Of `path`: the one with the least margin, by scale_of. Only those count whose other value leads to another skill.
  std::optional<std::size_t> narrowest;
};

/// Explains the decision. `state` is that of its tick, and `behaviour` has made it.
Why why(const Params& params, const agent::TreeBehaviour& behaviour, const Decision& decision, const State& state);

/// Finds the sources of each comparison. `why` is of this tree. Takes about a millisecond.
void find_sources(const Params& params, const agent::Tree& tree, Why& why);

/// Returns the sentence on top: "14/3 plays kick because role is chaser; …". `name` is that of the robot.
std::string sentence_of(const Why& why, const agent::Tree& tree, const std::string& name);
/// Returns the sentence, and a line per comparison.
std::string text_of(const Why& why, const agent::Tree& tree, const std::string& name);

/// Returns a value with its unit: "0.35 m", "20 deg", "yes", "chaser", "unknown".
std::string value_text(agent::Feature feature, float value);
/// Returns what the robot does there: "kick (baseline/ball known/kick)".
std::string leaf_text(const agent::Tree& tree, std::uint16_t leaf);

}  // namespace sim::debug
