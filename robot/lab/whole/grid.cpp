#include "robot/lab/whole/grid.h"

#include <algorithm>

namespace robot::lab {
namespace {

constexpr std::uint64_t kLongest = std::uint64_t{1} << 62;  // [ns] 146 years: sums of shorter spans cannot overflow

std::uint64_t span_of(std::uint64_t from_ns, std::uint64_t to_ns) { return std::min(to_ns - from_ns, kLongest); }

}  // namespace

std::uint64_t step_of(std::uint64_t from_ns, std::uint64_t to_ns, std::size_t most) {
  return span_of(from_ns, to_ns) / most + 1;
}

Grid::Grid(std::uint64_t from_ns, std::uint64_t to_ns, std::size_t most)
    : from_ns_(from_ns), step_ns_(step_of(from_ns, to_ns, most)), intervals_(span_of(from_ns, to_ns) / step_ns_ + 1) {}

void Grid::add(std::uint64_t at_ns, double value) {
  if (at_ns < from_ns_) return;
  const std::uint64_t i = (at_ns - from_ns_) / step_ns_;
  if (i < intervals_.size()) intervals_[i].add(value);
}

Grid Grid::part(std::uint64_t from_ns, std::uint64_t to_ns, std::size_t most) const {
  const std::size_t end = intervals_.size() - 1;
  const auto place = [&](std::uint64_t at_ns) {
    return at_ns < from_ns_ ? 0 : std::min<std::uint64_t>((at_ns - from_ns_) / step_ns_, end);
  };
  const std::size_t first = place(from_ns), last = std::max(first, place(to_ns));
  const std::size_t together = (last - first) / most + 1;  // intervals that become one
  Grid coarse(from_ns_ + first * step_ns_, step_ns_ * together);
  coarse.intervals_.resize((last - first) / together + 1);
  for (std::size_t i = first; i <= last; ++i) coarse.intervals_[(i - first) / together].merge(intervals_[i]);
  return coarse;
}

}  // namespace robot::lab
