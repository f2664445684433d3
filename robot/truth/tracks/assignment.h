// The assignment of rows to columns with the least sum of costs.
#pragma once

#include <cstddef>
#include <vector>

namespace robot::truth {

/// Costs of pairs, row by row.
struct CostTable {
  std::size_t rows = 0, columns = 0;
  std::vector<double> costs;

  /// Makes the table this large, with all costs 0. Keeps its memory.
  void reset(std::size_t new_rows, std::size_t new_columns) {
    rows = new_rows;
    columns = new_columns;
    costs.assign(rows * columns, 0);
  }
  double& at(std::size_t row, std::size_t column) { return costs[row * columns + column]; }
  double at(std::size_t row, std::size_t column) const { return costs[row * columns + column]; }
};

/// The Hungarian method (Kuhn 1955, with potentials), O(rows² columns). Keeps its memory between calls.
class Assignment {
 public:
  /// Returns the column of each row, each column at most once. All costs are finite; rows <= columns (asserted).
  const std::vector<std::size_t>& solve(const CostTable& table);

 private:
  void begin(std::size_t rows, std::size_t columns);
  void add_row(const CostTable& table, std::size_t row);
  std::size_t nearest_free(const CostTable& table, std::size_t column);

  // index 0 of each is a stand-in: no row, no column
  std::vector<double> row_price_, column_price_, slack_;
  std::vector<std::size_t> row_of_, came_from_;
  std::vector<char> visited_;
  std::vector<std::size_t> column_of_;
};

}  // namespace robot::truth
