#include "robot/truth/feeds/truth_csv.h"

#include <charconv>
#include <cmath>
#include <cstdint>
#include <optional>
#include <utility>

#include "robot/core/text.h"
#include "robot/truth/feeds/angle.h"
#include "robot/truth/feeds/csv_header.h"
#include "robot/truth/feeds/csv_time.h"

namespace robot::truth {
namespace {

constexpr double kFarthest = 100;                              // [m]
constexpr double kLargestHeading = 1000;                       // [rad] trackers that count turns
constexpr double kLastTimeNs = 9e18;                           // the year 2255
constexpr std::uint64_t kDatedNs = 1'000'000'000'000'000'000;  // 2001
constexpr std::size_t kLongestHeader = 65'536;                 // [bytes]
constexpr int kMostRobots = 500;                               // at one moment of the long form

/// Takes the next line off `text`, without its end.
std::string_view take_line(std::string_view& text) {
  const std::size_t end = text.find('\n');
  std::string_view line = text.substr(0, end);
  text.remove_prefix(end == text.npos ? text.size() : end + 1);
  if (line.ends_with('\r')) line.remove_suffix(1);
  return line;
}

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

/// The cells of one line. The first wrong cell is kept as a sentence.
class Row {
 public:
  Row(const CsvHeader& header, std::string_view line) : header_(header), cells_(csv_cells(line, header.separator)) {
    if (cells_.size() != header.names.size())
      fault_ = formatted("expected %zu cells, got %zu", header.names.size(), cells_.size());
    cells_.resize(header.names.size());
  }

  const std::string& fault() const { return fault_; }

  /// Returns the number in a column [m or rad], or nothing if it is absent.
  std::optional<double> number(const CsvColumn& column, double limit) {
    const std::string_view cell = cells_[column.index];
    if (is_absent(cell)) return std::nullopt;
    const auto value = number_in<double>(cell);
    if (value && std::abs(*value * column.scale) <= limit) return *value * column.scale;
    complain(column.index, formatted("a number of %g .. %g [%s]", -limit / column.scale, limit / column.scale,
                                     std::string(column.unit).c_str()));
    return std::nullopt;
  }

  /// Returns the time [ns].
  std::uint64_t time_ns() {
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

  /// Returns the number of a team or player in [least, most], or nothing if it is absent.
  std::optional<std::uint32_t> id(std::size_t index, std::uint32_t least, std::uint32_t most) {
    if (is_absent(cells_[index])) return std::nullopt;
    const auto value = number_in<std::uint32_t>(cells_[index]);
    if (value && *value >= least && *value <= most) return value;
    complain(index, formatted("a whole number of %u .. %u", least, most));
    return std::nullopt;
  }

  bool says(std::size_t index, std::string_view word) const { return cells_[index] == word; }

  void complain(std::size_t index, const std::string& expected) {
    if (fault_.empty())
      fault_ =
          "column " + header_.names[index] + ": expected " + expected + ", got '" + printable(cells_[index], 40) + "'";
  }

 private:
  const CsvHeader& header_;
  std::vector<std::string_view> cells_;
  std::string fault_;
};

/// A place in a row. Absent as a whole if the thing was not seen.
struct RowPlace {
  double x = 0, y = 0;
};

std::optional<RowPlace> place_in(Row& row, const CsvThing& thing) {
  const auto x = row.number(*thing.x, kFarthest), y = row.number(*thing.y, kFarthest);
  if (x && y) return RowPlace{*x, *y};
  if (x || y) row.complain((x ? thing.y : thing.x)->index, "a number, because x or y is there");
  return std::nullopt;
}

/// Adds the things of one row to a message.
class Filler {
 public:
  Filler(const CsvHeader& header, Row& row, pb::GroundTruth& truth) : header_(header), row_(row), truth_(truth) {}

  void fill() {
    for (const CsvThing& thing : header_.things) add(thing);
  }

 private:
  void add(const CsvThing& thing) {
    const auto place = place_in(row_, thing);
    if (!place) return;
    if (thing.ball || (header_.team && row_.says(*header_.team, "ball")))
      add_ball(*place);
    else
      add_robot(thing, *place);
  }

  void add_ball(const RowPlace& place) {
    if (truth_.has_ball() && header_.team) row_.complain(*header_.team, "one ball at a time");
    truth_.mutable_ball()->set_x(static_cast<float>(place.x));
    truth_.mutable_ball()->set_y(static_cast<float>(place.y));
  }

  void add_robot(const CsvThing& thing, const RowPlace& place) {
    if (header_.team && truth_.robots_size() >= kMostRobots)
      return row_.complain(header_.time.index, formatted("at most %d robots at a time", kMostRobots));
    pb::GroundTruth::TrueRobot& robot = *truth_.add_robots();
    robot.set_x(static_cast<float>(place.x));
    robot.set_y(static_cast<float>(place.y));
    const auto team = header_.team ? row_.id(*header_.team, 0, kMaxTeam) : thing.team;
    const auto player = header_.player ? row_.id(*header_.player, 1, kMaxPlayer) : thing.player;
    if (team) robot.set_team(*team);
    if (player) robot.set_player(*player);
    const auto heading = thing.heading ? row_.number(*thing.heading, kLargestHeading) : std::nullopt;
    if (heading) robot.set_heading(static_cast<float>(in_one_turn(*heading)));
  }

  const CsvHeader& header_;
  Row& row_;
  pb::GroundTruth& truth_;
};

/// Adds a line to the moments. Returns a sentence if it is wrong; the moments are then as before.
std::string add_line(const CsvHeader& header, std::string_view line, std::vector<TimedTruth>& moments) {
  Row row(header, line);
  if (!row.fault().empty()) return row.fault();
  const std::uint64_t time_ns = row.time_ns();
  const bool later = moments.empty() || time_ns > moments.back().capture_ns;
  if (!later && time_ns < moments.back().capture_ns)
    row.complain(header.time.index, "a time that is not before that of the line above");
  const bool joins = header.team && !later;  // a line of the long form that belongs to the moment of the line above
  TimedTruth moment{.capture_ns = time_ns, .truth = joins ? moments.back().truth : pb::GroundTruth()};
  Filler(header, row, moment.truth).fill();
  if (!row.fault().empty()) return row.fault();
  if (joins)
    moments.back() = std::move(moment);
  else
    moments.push_back(std::move(moment));
  return "";
}

}  // namespace

bool is_truth_csv(std::string_view text) {
  text = text.substr(0, kLongestHeader);
  return static_cast<bool>(read_csv_header(take_line(text)));
}

Result<TruthCsv> read_truth_csv(std::string_view text) {
  const Result<CsvHeader> header = read_csv_header(take_line(text));
  if (!header) return header.failure("line 1");
  TruthCsv csv{.moments = {}, .dated = false, .ignored = header->ignored, .damage = ""};
  for (std::size_t number = 2; !text.empty() && csv.damage.empty(); ++number) {
    const std::string_view line = take_line(text);
    if (trimmed(line).empty()) continue;
    const std::string fault = add_line(*header, line, csv.moments);
    if (!fault.empty()) csv.damage = "line " + std::to_string(number) + ", " + fault;
  }
  csv.dated = !csv.moments.empty() && csv.moments.front().capture_ns >= kDatedNs;
  return csv;
}

}  // namespace robot::truth
