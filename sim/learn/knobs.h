// The numbers of a strategy that may be learned: its parameters, the arguments of its leaves, the thresholds of its
// conditions.
#pragma once

#include <limits>
#include <span>
#include <string>
#include <vector>

#include "robot/core/result.h"
#include "sim/io/json.h"
#include "sim/io/values.h"
#include "sim/learn/change.h"

namespace sim::learn {

/// One number of a strategy. Values are in SI, as the simulator has them.
struct Knob {
  std::string name;   // for people: "near_ball", "shoot / free: range"
  std::string place;  // of its text, as a JSON pointer: "/parameters/near_ball"
  int term = -1;      // of a condition: the number of the comparison; -1: the text is the number
  io::Expected expected{};
  float least = 0, most = 0;
  float value = 0;
  std::vector<std::string> skills, features;  // that it is an argument of, or that are compared with it
};

inline constexpr float kUnlimited = std::numeric_limits<float>::infinity();

/// Returns the knobs of a flattened strategy (io::flattened), in the order of its text. A mark gives the range of a number.
///
/// Without a mark, the range is a third to three times the value. For a number that may be negative, it is a quarter of
/// the allowed range to each side. It stays within the limits of skill and feature, and a distance within `farthest` [m]:
/// beyond the field's diagonal all thresholds mean the same. Names, counts and features that never change in a game have no
/// knobs.
robot::Result<std::vector<Knob>> knobs_of(const io::Json& strategy, float farthest = kUnlimited);

/// Returns the nearest value that a person would write: a step is about a hundredth of the range.
float rounded(const Knob& knob, float value);

/// Returns the value as a strategy writes it: "0.5 m"; angles in degrees.
std::string text_of(const Knob& knob, float value);

/// Returns the strategy with other values, one for each knob.
io::Json with_values(io::Json strategy, std::span<const Knob> knobs, std::span<const float> values);

/// Returns a change for each knob that differs.
std::vector<Change> changes(std::span<const Knob> knobs, std::span<const float> values);

}  // namespace sim::learn
