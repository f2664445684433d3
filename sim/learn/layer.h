// A layer of learning: the part of a strategy that it may change, and the exercises that judge it. Layers are data
// (sim/data/layers):
//
//   {
//     "about": "when to kick, and where",
//     "skills": ["kick", "dribble"],                // their arguments
//     "leaves": ["kick"],                           // skills of the leaves that may get other actions; default: "skills"
//     "features": ["ball_goal_distance"],           // the thresholds of their comparisons
//     "conditions": ["opponent_ball_distance"],     // features of new conditions
//     "actions": [{ "do": "dribble" }],             // other actions for a leaf
//     "exercises": { "empty_goal": 1, "game": 2 }   // drills, or whole games, by their weight
//   }
#pragma once

#include <string>
#include <utility>
#include <vector>

#include "robot/core/result.h"
#include "sim/io/json.h"
#include "sim/learn/knobs.h"

namespace sim::learn {

/// The exercise of whole games against the opponents of the run.
inline constexpr const char* kGame = "game";

struct Layer {
  std::string name;
  std::string about;
  std::vector<std::string> skills, leaves, features, conditions;
  std::vector<std::string> actions;  // rules as JSON
  std::vector<std::pair<std::string, double>> exercises;

  /// Returns whether the knob belongs to the layer: by one of its uses.
  bool has(const Knob& knob) const;
};

/// Parses a layer. `called` opens the sentence of an Error.
robot::Result<Layer> parse_layer(std::string_view text, const std::string& called, const std::string& name);

/// Loads an embedded layer by name ("follow", "kick", "pass", "role"), or a file by path.
robot::Result<Layer> load_layer(const std::string& name);

/// Returns the conditions and knobs of both layers, judged by the exercises of the upper one.
Layer seam_of(const Layer& lower, const Layer& upper);

}  // namespace sim::learn
