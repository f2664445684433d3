#include "robot/truth/feeds/csv_row.h"

#include <charconv>
#include <cmath>

#include "robot/core/text.h"
#include "robot/truth/feeds/csv_time.h"

namespace robot::truth {
namespace {

constexpr double kLastTimeNs = 9e18;  // the year 2255

template <class Number>
std::optional<Number> number_in(std::string_view text) {
  Number value = 0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
  if (error != std::errc() || end != text.data() + text.size()) return std::nullopt;
  return value;
}

/// Returns a time in nanoseconds. Today's seconds times 10^9 would be beyond the exact whole numbers of a double.
std::uint64_t nanoseconds_of(double time, double scale) {
  const double whole = std::floor(time);
  return static_cast<std::uint64_t>(whole) * static_cast<std::uint64_t>(scale) +
         static_cast<std::uint64_t>(std::llround((time - whole) * scale));
}

/// Reports whether a cell says that nothing was measured.
bool is_absent(std::string_view cell) { return cell.empty() || cell == "nan" || cell == "NaN" || cell == "NAN"; }

}  // namespace

CsvRow::CsvRow(const CsvHeader& header, std::string_view line)
    : header_(header), cells_(csv_cells(line, header.separator)) {
  if (cells_.size() != header.names.size())
    fault_ = formatted("expected %zu cells, got %zu", header.names.size(), cells_.size());
  cells_.resize(header.names.size());
}

std::optional<double> CsvRow::number(const CsvColumn& column, double limit) {
  const std::string_view cell = cells_[column.index];
  if (is_absent(cell)) return std::nullopt;
  const auto value = number_in<double>(cell);
  if (value && std::abs(*value * column.scale) <= limit) return *value * column.scale;
  complain(column.index, formatted("a number of %g .. %g [%s]", -limit / column.scale, limit / column.scale,
                                   std::string(column.unit).c_str()));
  return std::nullopt;
}

std::uint64_t CsvRow::time_ns() {
  const CsvColumn& column = header_.time;
  const std::string_view cell = cells_[column.index];
  if (const auto iso = parse_iso_time(cell)) return *iso;
  const auto whole = number_in<std::uint64_t>(cell);
  if (whole && column.scale == 1 && static_cast<double>(*whole) <= kLastTimeNs) return *whole;
  const auto value = number_in<double>(cell);
  if (value && *value >= 0 && *value * column.scale <= kLastTimeNs) return nanoseconds_of(*value, column.scale);
  complain(column.index,
           formatted("a time [%s] of at least 0 or as in 2026-03-14T15:09:26Z", std::string(column.unit).c_str()));
  return 0;
}

std::optional<std::uint32_t> CsvRow::id(std::size_t index, std::uint32_t least, std::uint32_t most) {
  if (is_absent(cells_[index])) return std::nullopt;
  const auto value = number_in<std::uint32_t>(cells_[index]);
  if (value && *value >= least && *value <= most) return value;
  complain(index, formatted("a whole number of %u .. %u", least, most));
  return std::nullopt;
}

void CsvRow::complain(std::size_t index, const std::string& expected) {
  if (fault_.empty())
    fault_ =
        "column " + header_.names[index] + ": expected " + expected + ", got '" + printable(cells_[index], 40) + "'";
}

}  // namespace robot::truth
