// The header of a CSV file of positions: which column holds what, in which unit.
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "robot/core/result.h"

namespace robot::truth {

/// A column of numbers with its unit.
struct CsvColumn {
  std::size_t index = 0;
  double scale = 1;       // of a number in this column to metres, radians or nanoseconds
  std::string_view unit;  // as in sentences: "mm"
};

/// A robot or the ball, and the columns with its place.
struct CsvThing {
  bool ball = false;
  std::optional<std::uint32_t> team = {}, player = {};    // absent for the ball and in the long form
  std::optional<CsvColumn> x = {}, y = {}, heading = {};  // x and y are always there
};

/// The columns of a file.
struct CsvHeader {
  char separator = ',';  // or ';' or a tab
  std::vector<std::string> names;
  CsvColumn time;
  std::optional<std::size_t> team, player;  // columns of the long form: one row for each thing
  std::vector<CsvThing> things;             // of one row
  std::vector<std::string> ignored;         // names of columns of other data
};

/// Reads the first line of a file. truth_csv.h describes the names. Returns an Error if a column that is needed is absent
/// or a column is there twice.
Result<CsvHeader> read_csv_header(std::string_view line);

/// Returns the cells of a line, without blanks and quotes around them. They point into `line`.
std::vector<std::string_view> csv_cells(std::string_view line, char separator);

}  // namespace robot::truth
