#include "robot/truth/tracks/assignment.h"

#include <cassert>
#include <limits>

namespace robot::truth {

void Assignment::begin(std::size_t rows, std::size_t columns) {
  row_price_.assign(rows + 1, 0);
  column_price_.assign(columns + 1, 0);
  row_of_.assign(columns + 1, 0);
  came_from_.assign(columns + 1, 0);
  column_of_.assign(rows, 0);
}

/// Visits the column, lets the prices rise until another column can be reached, and returns that one.
std::size_t Assignment::nearest_free(const CostTable& table, std::size_t column) {
  visited_[column] = 1;
  const std::size_t row = row_of_[column];
  double rise = std::numeric_limits<double>::infinity();
  std::size_t nearest = 0;
  for (std::size_t other = 1; other <= table.columns; ++other) {
    if (visited_[other]) continue;
    const double reduced = table.at(row - 1, other - 1) - row_price_[row] - column_price_[other];
    if (reduced < slack_[other]) {
      slack_[other] = reduced;
      came_from_[other] = column;
    }
    if (slack_[other] < rise) {
      rise = slack_[other];
      nearest = other;
    }
  }
  for (std::size_t other = 0; other <= table.columns; ++other) {
    if (visited_[other]) {
      row_price_[row_of_[other]] += rise;
      column_price_[other] -= rise;
    } else {
      slack_[other] -= rise;
    }
  }
  return nearest;
}

/// Finds a column for one more row, along the path that costs the others least.
void Assignment::add_row(const CostTable& table, std::size_t row) {
  slack_.assign(table.columns + 1, std::numeric_limits<double>::infinity());
  visited_.assign(table.columns + 1, 0);
  row_of_[0] = row;
  std::size_t column = 0;
  do {
    column = nearest_free(table, column);
  } while (row_of_[column] != 0);

  // each row on the path moves to the next column
  for (; column != 0; column = came_from_[column]) row_of_[column] = row_of_[came_from_[column]];
}

const std::vector<std::size_t>& Assignment::solve(const CostTable& table) {
  assert(table.rows <= table.columns);
  begin(table.rows, table.columns);
  for (std::size_t row = 1; row <= table.rows; ++row) add_row(table, row);
  for (std::size_t column = 1; column <= table.columns; ++column)
    if (row_of_[column] != 0) column_of_[row_of_[column] - 1] = column - 1;
  return column_of_;
}

}  // namespace robot::truth
