#include "robot/lab/whole/grid.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <random>

namespace robot::lab {
namespace {

constexpr double kInfinity = std::numeric_limits<double>::infinity();

struct Value {
  std::uint64_t at_ns;
  double value;
};

std::vector<Value> some_values(std::uint32_t seed, std::uint64_t from_ns, std::uint64_t to_ns, int count) {
  std::mt19937_64 random(seed);
  std::vector<Value> values;
  for (int i = 0; i < count; ++i)  // whole numbers: their sums are exact
    values.push_back({from_ns + random() % (to_ns - from_ns + 1), static_cast<double>(random() % 2001) - 1000});
  return values;
}

/// Computes the interval from `from_ns` until `end_ns`, which is not included, at once.
Interval at_once(const std::vector<Value>& values, std::uint64_t from_ns, std::uint64_t end_ns) {
  Interval interval;
  for (const auto& [at_ns, value] : values)
    if (at_ns >= from_ns && at_ns < end_ns) interval.add(value);
  return interval;
}

void expect_same(const Interval& one, const Interval& other) {
  EXPECT_EQ(one.count, other.count);
  EXPECT_EQ(one.least, other.least);
  EXPECT_EQ(one.most, other.most);
  EXPECT_EQ(one.sum, other.sum);
}

TEST(Interval, TheMeanLiesBetweenMinimumAndMaximum) {
  std::mt19937_64 random(5);
  for (int round = 0; round < 2000; ++round) {
    Interval interval;
    const double scale = std::pow(10., static_cast<double>(random() % 617) - 308);
    for (std::uint64_t i = random() % 9 + 1; i > 0; --i)
      interval.add(scale * ((static_cast<double>(random() % 2001) - 1000) / 1000));
    EXPECT_LE(interval.least, interval.mean());
    EXPECT_LE(interval.mean(), interval.most);
  }
  Interval greatest;
  for (const double value : {1., -1., 1., -1., -1.}) greatest.add(value * std::numeric_limits<double>::max());
  EXPECT_LE(greatest.least, greatest.mean());
  EXPECT_LE(greatest.mean(), greatest.most);
  Interval one = greatest, other;
  for (int i = 0; i < 3; ++i) one.add(std::numeric_limits<double>::max());
  for (int i = 0; i < 3; ++i) other.add(-std::numeric_limits<double>::max());
  one.merge(other);
  EXPECT_LE(one.least, one.mean());
  EXPECT_LE(one.mean(), one.most);
}

TEST(Interval, LeavesOutValuesThatAreNotFinite) {
  Interval interval;
  for (const double value : {std::nan(""), kInfinity, -kInfinity}) interval.add(value);
  EXPECT_EQ(interval.count, 0u);
  interval.add(3);
  EXPECT_EQ(interval.count, 1u);
  EXPECT_EQ(interval.mean(), 3);
}

TEST(Grid, HoldsEachValueInTheIntervalOfItsTime) {
  const auto values = some_values(1, 1000, 9999, 500);
  for (const std::size_t most : {1, 2, 7, 800, 20'000}) {
    Grid grid(1000, 9999, most);
    for (const auto& [at_ns, value] : values) grid.add(at_ns, value);
    EXPECT_LE(grid.intervals().size(), most);
    std::uint64_t from_ns = grid.from_ns();
    for (const Interval& interval : grid.intervals()) {
      expect_same(interval, at_once(values, from_ns, from_ns + grid.step_ns()));
      from_ns += grid.step_ns();
    }
    EXPECT_GT(from_ns, 9999u) << "it covers the range";
  }
}

TEST(Grid, ToMergeIntervalsEqualsComputingAtOnce) {
  const auto values = some_values(2, 0, 1'000'000, 3000);
  Grid grid(0, 1'000'000, 4096);
  for (const auto& [at_ns, value] : values) grid.add(at_ns, value);
  std::mt19937_64 random(3);
  for (int round = 0; round < 200; ++round) {
    const std::uint64_t one = random() % 1'000'001, other = random() % 1'000'001, most = 1 + random() % 900;
    const auto [from_ns, to_ns] = std::minmax(one, other);
    const Grid part = grid.part(from_ns, to_ns, most);
    EXPECT_LE(part.intervals().size(), most);
    EXPECT_LE(part.from_ns(), from_ns);
    EXPECT_GT(part.from_ns() + grid.step_ns(), from_ns) << "it begins less than one interval earlier";
    EXPECT_GT(part.from_ns() + part.intervals().size() * part.step_ns(), to_ns) << "it covers the range";
    for (std::size_t i = 0; i + 1 < part.intervals().size(); ++i)
      expect_same(part.intervals()[i],
                  at_once(values, part.from_ns() + i * part.step_ns(), part.from_ns() + (i + 1) * part.step_ns()));
  }
}

TEST(Grid, ValuesBeyondItAreLeftOut) {
  Grid grid(1000, 1999, 10);
  for (const std::uint64_t at_ns : {std::uint64_t{0}, std::uint64_t{999}, std::uint64_t{2000}, UINT64_MAX})
    grid.add(at_ns, 1);
  for (const Interval& interval : grid.intervals()) EXPECT_EQ(interval.count, 0u);
}

TEST(Grid, AHostileRangeGivesAnInterval) {
  Grid grid(1000, 1999, 10);
  grid.add(1000, 1);
  grid.add(1999, 2);
  EXPECT_EQ(grid.part(0, 10, 5).intervals().size(), 1u);
  EXPECT_EQ(grid.part(0, 10, 5).intervals()[0].most, 1);
  EXPECT_EQ(grid.part(UINT64_MAX, UINT64_MAX, 5).intervals()[0].most, 2);
  EXPECT_EQ(grid.part(0, UINT64_MAX, 1).intervals()[0].count, 2u);
  Grid whole(0, UINT64_MAX, 1);
  whole.add(7, 7);
  EXPECT_EQ(whole.intervals().size(), 1u);
  EXPECT_EQ(whole.part(0, UINT64_MAX, 1).intervals()[0].most, 7);
  EXPECT_LE(Grid(0, UINT64_MAX, 4096).intervals().size(), 4096u);
  EXPECT_EQ(Grid(5, 5, 4096).intervals().size(), 1u);
}

}  // namespace
}  // namespace robot::lab
