// Planted figures, fitted again and again: the share of intervals that cover them, and the bias.
#pragma once

#include <map>
#include <string>
#include <vector>

#include "robot/fit/report.h"
#include "sim/statistics/sample.h"

namespace bench {

inline constexpr double kTruthError = 0.02;         // [m] of the truth's places
inline constexpr double kClockError = 0.02 / 1.96;  // [s] an interval of 20 ms that covers 95 % of all recordings

/// The fits of several planted figures.
class Planted {
 public:
  /// `values` are the planted ones by the figures' names. `prefix` stands before the names in the report.
  explicit Planted(std::map<std::string, double> values, std::string prefix = "")
      : values_(std::move(values)), prefix_(std::move(prefix)) {}

  /// Counts those of the figures that were planted.
  void add(const std::vector<robot::fit::Figure>& figures);
  void add(const robot::fit::Report& report) { add(report.figures); }

  /// Prints a line of JSON for each figure.
  void print() const;

 private:
  struct Tally {
    sim::statistics::Share covered;
    std::vector<double> bias, half_widths;
  };
  std::map<std::string, double> values_;
  std::string prefix_;
  std::map<std::string, Tally> tallies_;
};

/// The cases of bench_fit. Each prints its lines.
void study(int repetitions);
void kicks(int repetitions);
void partial_kicks(int repetitions);
void ball_distance(int repetitions);
void rolling(int repetitions);
void rebounds(int repetitions);
void falls(int repetitions);
void sights(int repetitions);
void visibility(int repetitions);
void radio(int repetitions);
void walking(int repetitions);
void odometry(int repetitions);
void localisation(int repetitions);
void games(int repetitions);

}  // namespace bench
