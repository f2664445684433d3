// One line of a CSV file of positions.
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "robot/truth/feeds/csv_header.h"

namespace robot::truth {

/// The cells of one line. The first wrong cell is kept as a sentence. The header and the line outlive it.
class CsvRow {
 public:
  CsvRow(const CsvHeader& header, std::string_view line);

  /// Returns a sentence with column, expected and actual value, or an empty one while nothing is wrong.
  const std::string& fault() const { return fault_; }

  /// Returns the number in a column [m or rad], or nothing if it is absent. It is wrong beyond `limit` [m or rad].
  std::optional<double> number(const CsvColumn& column, double limit);

  /// Returns the time [ns].
  std::uint64_t time_ns();

  /// Returns the number of a team or player in [least, most], or nothing if it is absent.
  std::optional<std::uint32_t> id(std::size_t index, std::uint32_t least, std::uint32_t most);

  bool says(std::size_t index, std::string_view word) const { return cells_[index] == word; }

  /// Keeps a sentence about the cell in a column, unless another cell is wrong already.
  void complain(std::size_t index, const std::string& expected);

 private:
  const CsvHeader& header_;
  std::vector<std::string_view> cells_;
  std::string fault_;
};

}  // namespace robot::truth
