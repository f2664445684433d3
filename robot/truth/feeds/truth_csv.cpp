#include "robot/truth/feeds/truth_csv.h"

#include <cstdint>
#include <optional>
#include <utility>

#include "robot/core/text.h"
#include "robot/truth/feeds/angle.h"
#include "robot/truth/feeds/csv_header.h"
#include "robot/truth/feeds/csv_row.h"

namespace robot::truth {
namespace {

constexpr double kFarthest = 100;                              // [m]
constexpr double kLargestHeading = 1000;                       // [rad] trackers that count turns
constexpr std::uint64_t kDatedNs = 1'000'000'000'000'000'000;  // 2001
constexpr std::size_t kLongestHeader = 65'536;                 // [bytes]
constexpr int kMostRobots = 500;                               // at one moment of the long form

/// A place in a row. Absent as a whole if the thing was not seen.
struct RowPlace {
  double x = 0, y = 0;
};

std::optional<RowPlace> place_in(CsvRow& row, const CsvThing& thing) {
  const auto x = row.number(*thing.x, kFarthest), y = row.number(*thing.y, kFarthest);
  if (x && y) return RowPlace{*x, *y};
  if (x || y) row.complain((x ? thing.y : thing.x)->index, "a number, because x or y is there");
  return std::nullopt;
}

/// Adds the things of one row to a message.
class Filler {
 public:
  Filler(const CsvHeader& header, CsvRow& row, pb::GroundTruth& truth) : header_(header), row_(row), truth_(truth) {}

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
  CsvRow& row_;
  pb::GroundTruth& truth_;
};

/// Adds a line to the moments. Returns a sentence if it is wrong; the moments are then as before.
std::string add_line(const CsvHeader& header, std::string_view line, std::vector<TimedTruth>& moments) {
  CsvRow row(header, line);
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
