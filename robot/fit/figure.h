// A fitted figure, with all that a reader needs to judge it.
#pragma once

#include <cmath>
#include <cstddef>
#include <optional>
#include <string>
#include <vector>

namespace robot::fit {

/// The range of observations behind a figure. Beyond it nothing is known.
struct Domain {
  std::string quantity, unit;  // "true distance", "m"
  double from = 0, to = 0;
};

struct Figure {
  std::string name;  // "ball.deceleration": as in the models, or a name of its own
  std::string unit;  // "m/s²"
  double value = 0;
  double low = 0, high = 0;  // interval that covers 95 %
  std::size_t events = 0;    // independent ones
  std::string kind;          // of the events: "rolls"
  std::vector<std::string> recordings;
  Domain domain;
  double widest = INFINITY;  // half the widest interval that is worth more than a default

  /// Reports whether the recordings know it well enough to replace a default.
  bool is_known() const { return (high - low) / 2 <= widest; }
};

/// Formats a figure: "0.302 m/s² (95 %: 0.295 .. 0.309), 41 rolls of 3 recordings, speed 0.25 .. 2.1 m/s".
std::string to_text(const Figure& figure);

/// The observations behind a fit, a row for each one.
struct Table {
  std::vector<std::string> columns;  // name and unit: "distance [m]"
  std::vector<std::string> names;    // of the recordings, by index
  struct Row {
    std::size_t recording = 0;
    std::vector<double> values;  // one for each column
  };
  std::vector<Row> rows;
};

/// Formats the table as CSV (RFC 4180) with a head. The first column is the recording.
std::string to_csv(const Table& table);

}  // namespace robot::fit
