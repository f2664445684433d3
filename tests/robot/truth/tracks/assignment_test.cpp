#include "robot/truth/tracks/assignment.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <numeric>

#include "tests/support/truth_game.h"

namespace robot::truth {
namespace {

double cost_of(const CostTable& table, const std::vector<std::size_t>& columns) {
  double sum = 0;
  for (std::size_t row = 0; row < table.rows; ++row) sum += table.at(row, columns[row]);
  return sum;
}

/// Tries all assignments.
double least_cost(const CostTable& table) {
  std::vector<std::size_t> columns(table.columns);
  std::iota(columns.begin(), columns.end(), 0u);
  double least = cost_of(table, columns);
  while (std::next_permutation(columns.begin(), columns.end())) least = std::min(least, cost_of(table, columns));
  return least;
}

TEST(Assignment, HasTheLeastSumOfCosts) {
  test::Random random(1);
  Assignment assignment;
  for (int trial = 0; trial < 100; ++trial) {
    CostTable table;
    table.reset(1 + static_cast<std::size_t>(trial % 4), 4 + static_cast<std::size_t>(trial % 2));
    for (double& cost : table.costs) cost = random.uniform(-5, 5);
    EXPECT_NEAR(cost_of(table, assignment.solve(table)), least_cost(table), 1e-9) << trial;
  }
}

TEST(Assignment, UsesEachColumnAtMostOnce) {
  test::Random random(2);
  CostTable table;
  table.reset(14, 28);
  for (double& cost : table.costs) cost = random.uniform(0, 1);
  Assignment assignment;
  std::vector<std::size_t> columns = assignment.solve(table);
  std::sort(columns.begin(), columns.end());
  EXPECT_EQ(std::unique(columns.begin(), columns.end()), columns.end());
  EXPECT_LT(columns.back(), 28u);
}

TEST(Assignment, OfNoRowsIsEmpty) {
  CostTable table;
  table.reset(0, 3);
  EXPECT_TRUE(Assignment().solve(table).empty());
}

}  // namespace
}  // namespace robot::truth
