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
#include "sim/math/lanes.h"

namespace sim::agent {

inline constexpr int kMaxColumns = 512;

/// One number of an observation, as a formula of a feature's value.
struct Column {
  enum class Form : std::uint8_t { linear, squashed, word, known };

  Feature feature{};
  Form form = Form::linear;
  float offset = 0;  // linear: (value - offset) * factor
  float factor = 1;
  float scale = 1;  // squashed: value / (scale + |value|), in the unit of the feature
  float word = 0;   // word: the value for which the column is 1
};

/// Returns all built-in features, in the order of their ids.
std::vector<Feature> built_in_features();

/// Returns the name: "ball_distance", "role=keeper", "pass_gain known".
std::string name_of(const Column& column);
/// Returns the formula of the column: "value / (1 m + |value|)".
std::string formula_of(const Column& column);

/// The columns of some features. Immutable.
class Columns {
 public:
  Columns() = default;
  /// The columns are in the order of the features.
  explicit Columns(std::span<const Feature> features);

  int count() const { return static_cast<int>(list_.size()); }
  const std::vector<Column>& list() const { return list_; }

  /// Writes the value of each column to `row`. Each is in [-1, 1]. Allocates nothing. There are at most kMaxColumns.
  void observe(const View& view, float* row) const;

 private:
  /// The terms of x / (base + slope * |x|) with x = (value - offset) * factor, for several columns at once.
  struct Block {
    Lane<float> offset, factor, base, slope;
  };

  void add(const Column& column);

  std::vector<const FeatureInfo*> features_;
  std::vector<Column> list_;
  std::vector<std::uint16_t> feature_of_;  // by column: index in features_
  std::vector<Block> blocks_;              // columns 0 .. 7, 8 .. 15, …
  std::vector<int> words_, known_;         // columns of other forms
};

}  // namespace sim::agent
