// A number of a recording over time, as intervals of equal length.
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "robot/lab/whole/interval.h"

namespace robot::lab {

/// Consecutive intervals from a capture time on. Interval i holds the values from from_ns() + i * step_ns() until the
/// next one begins.
class Grid {
 public:
  /// Covers `from_ns` to `to_ns`, both included, with at most `most` intervals, without values. from_ns <= to_ns,
  /// most > 0. A range of more than 146 years is cut.
  Grid(std::uint64_t from_ns, std::uint64_t to_ns, std::size_t most);

  /// Adds a value that was captured at `at_ns`. Leaves out those beyond the grid.
  void add(std::uint64_t at_ns, double value);

  /// Returns a coarser grid over the part from `from_ns` to `to_ns` with at most `most` intervals. Its intervals consist
  /// of whole ones of this grid, so it may begin earlier and end later by less than one of these. The range is cut to
  /// the grid; one that misses it gives the interval at that end.
  Grid part(std::uint64_t from_ns, std::uint64_t to_ns, std::size_t most) const;

  std::uint64_t from_ns() const { return from_ns_; }
  std::uint64_t step_ns() const { return step_ns_; }
  const std::vector<Interval>& intervals() const { return intervals_; }

 private:
  Grid(std::uint64_t from_ns, std::uint64_t step_ns) : from_ns_(from_ns), step_ns_(step_ns) {}

  std::uint64_t from_ns_, step_ns_;
  std::vector<Interval> intervals_;
};

/// Returns the length of the intervals of a grid over this range [ns], at least 1.
std::uint64_t step_of(std::uint64_t from_ns, std::uint64_t to_ns, std::size_t most);

}  // namespace robot::lab
