// Observations of learners: the features of a robot's beliefs as a row of numbers in [-1, 1].
//
// A feature becomes one column or several:
//   - an angle, a share, or a small whole number: its value between the ends of its range, linear
//   - a length, speed, time, or count without an end: value / (scale + |value|), which is finest near 0
//   - a word such as the role: one column per word, 1 for the present word
//   - a feature that can be unknown while the ball is known: one more column, 1 while its value is known
// A value that the robot does not know is 0 in all columns.
#pragma once

#include <cstdint>
#include <span>
#include <string>
#include <vector>

#include "sim/agent/features.h"

namespace sim::agent {

inline constexpr int kMaxColumns = 512;

/// One number of an observation.
struct Column {
  enum class Form : std::uint8_t { linear, squashed, word, known };

  Feature feature{};
  Form form = Form::linear;
  float offset = 0;  // linear: (value - offset) * factor
  float factor = 1;
  float scale = 1;  // squashed: value / (scale + |value|), in the unit of the feature
  float word = 0;   // word: the value for which the column is 1
};

/// Returns the columns of these features, in the same order. Their number is at most kMaxColumns.
std::vector<Column> columns_of(std::span<const Feature> features);
/// Returns all built-in features, in the order of their ids.
std::vector<Feature> built_in_features();

/// Returns the name: "ball_distance", "role=keeper", "pass_gain known".
std::string name_of(const Column& column);
/// Returns the formula of the column: "value / (1 m + |value|)".
std::string formula_of(const Column& column);

/// Writes the value of each column to `row`. Each is in [-1, 1].
void observe(std::span<const Column> columns, const View& view, float* row);

}  // namespace sim::agent
