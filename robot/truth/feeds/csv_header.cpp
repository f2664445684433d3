#include "robot/truth/feeds/csv_header.h"

#include <algorithm>
#include <charconv>
#include <numbers>
#include <utility>

#include "robot/core/text.h"
#include "robot/truth/feeds/timed_truth.h"

namespace robot::truth {
namespace {

constexpr std::size_t kMostColumns = 1000;

enum class Measure { time, length, angle };

struct Unit {
  std::string_view name;
  Measure measure;
  double scale;  // to metres, radians or nanoseconds
};

/// The first unit of a measure is the one of columns that name none.
constexpr Unit kUnits[] = {
    {"s", Measure::time, 1e9},      {"ms", Measure::time, 1e6}, {"us", Measure::time, 1e3},
    {"ns", Measure::time, 1},       {"m", Measure::length, 1},  {"cm", Measure::length, 0.01},
    {"mm", Measure::length, 0.001}, {"rad", Measure::angle, 1}, {"deg", Measure::angle, std::numbers::pi / 180}};

/// The words of a column's name, without the unit at its end.
struct ColumnName {
  std::vector<std::string_view> words;
  const Unit* unit = nullptr;  // null: it names none

  /// Returns the column if its unit fits.
  std::optional<CsvColumn> measured(Measure measure, std::size_t index) const {
    const Unit* const used = unit ? unit : std::ranges::find(kUnits, measure, &Unit::measure);
    if (used->measure != measure) return std::nullopt;
    return CsvColumn{.index = index, .scale = used->scale, .unit = used->name};
  }
};

ColumnName column_name(std::string_view text) {
  ColumnName name{.words = split(text, "_"), .unit = nullptr};
  const Unit* const unit = std::ranges::find(kUnits, name.words.back(), &Unit::name);
  if (name.words.size() < 2 || unit == std::end(kUnits)) return name;
  name.words.pop_back();
  name.unit = unit;
  return name;
}

std::optional<std::uint32_t> number_of(std::string_view text, std::uint32_t least, std::uint32_t most) {
  std::uint32_t value = 0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
  if (error != std::errc() || end != text.data() + text.size() || value < least || value > most) return std::nullopt;
  return value;
}

/// Returns the thing to which a column of a place belongs: "ball_x", "x_14_2", or "x" of the long form. Returns nothing
/// for another column.
std::optional<CsvThing> thing_of(const std::vector<std::string_view>& words) {
  if (words.size() == 2 && words[0] == "ball") return CsvThing{.ball = true};
  CsvThing thing;
  if (words.size() == 1) return thing;
  if (words.size() != 3) return std::nullopt;
  thing.team = number_of(words[1], 0, kMaxTeam);
  thing.player = number_of(words[2], 1, kMaxPlayer);
  return thing.team && thing.player ? std::optional(thing) : std::nullopt;
}

bool same(const CsvThing& a, const CsvThing& b) { return a.ball == b.ball && a.team == b.team && a.player == b.player; }

/// Returns the names of the columns of a place, for sentences.
std::string columns_of(const CsvThing& thing) {
  if (thing.ball) return "ball_x and ball_y";
  if (!thing.team) return "x and y";
  return formatted("x_%u_%u and y_%u_%u", *thing.team, *thing.player, *thing.team, *thing.player);
}

/// Puts the columns of a header in their places.
class HeaderReader {
 public:
  explicit HeaderReader(CsvHeader& header) : header_(header) {}

  Result<void> take(std::size_t index) {
    const std::string& text = header_.names[index];
    const ColumnName name = column_name(text);
    bool fits = true;
    if (text == "team")
      fits = set(header_.team, index);
    else if (text == "player")
      fits = set(header_.player, index);
    else if (const auto time = time_of(name, index))
      fits = set(time_, *time);
    else if (const auto place = place_of(name, index))
      fits = set(*place->slot, place->column);
    else
      header_.ignored.push_back(printable(text, 40));
    if (!fits) return Error{"expected each column once, got '" + text + "' and another one like it"};
    return {};
  }

  /// Checks that nothing is absent.
  Result<void> complete() {
    if (!time_) return Error{"expected a column t, such as 't', 't_ns' or 'time', got none"};
    header_.time = *time_;
    if (header_.things.empty()) return Error{"expected columns ball_x, x_<team>_<player> or x, got none"};
    for (const CsvThing& thing : header_.things) {
      if (!thing.x || !thing.y)
        return Error{"expected both columns " + columns_of(thing) + ", got at most one of them"};
      const bool is_long = !thing.ball && !thing.team;
      if (is_long && !(header_.team && header_.player && header_.things.size() == 1))
        return Error{"expected columns team and player, and no others of places, beside a column x"};
      if (!is_long && (header_.team || header_.player)) return Error{"expected columns x and y beside team and player"};
    }
    return {};
  }

 private:
  struct PlaceColumn {
    std::optional<CsvColumn>* slot;
    CsvColumn column;
  };

  template <class Value>
  static bool set(std::optional<Value>& slot, const Value& value) {
    return !std::exchange(slot, value);
  }

  static std::optional<CsvColumn> time_of(const ColumnName& name, std::size_t index) {
    if (name.words.size() != 1 || (name.words[0] != "t" && name.words[0] != "time")) return std::nullopt;
    return name.measured(Measure::time, index);
  }

  std::optional<PlaceColumn> place_of(const ColumnName& name, std::size_t index) {
    const std::optional<CsvThing> thing = thing_of(name.words);
    if (!thing) return std::nullopt;
    const std::string_view axis = thing->ball ? name.words[1] : name.words[0];
    const bool heading = axis == "heading" && !thing->ball;
    if (axis != "x" && axis != "y" && !heading) return std::nullopt;
    const auto column = name.measured(heading ? Measure::angle : Measure::length, index);
    if (!column) return std::nullopt;
    auto found = std::ranges::find_if(header_.things, [&](const CsvThing& known) { return same(known, *thing); });
    if (found == header_.things.end()) found = header_.things.insert(found, *thing);
    return PlaceColumn{axis == "x" ? &found->x : axis == "y" ? &found->y : &found->heading, *column};
  }

  CsvHeader& header_;
  std::optional<CsvColumn> time_;
};

std::string_view unquoted(std::string_view cell) {
  if (cell.size() < 2 || cell.front() != '"' || cell.back() != '"') return cell;
  return trimmed(cell.substr(1, cell.size() - 2));
}

}  // namespace

std::vector<std::string_view> csv_cells(std::string_view line, char separator) {
  std::vector<std::string_view> cells;
  for (const std::string_view cell : split(line, {&separator, 1})) cells.push_back(unquoted(trimmed(cell)));
  return cells;
}

Result<CsvHeader> read_csv_header(std::string_view line) {
  if (line.starts_with("\xef\xbb\xbf")) line.remove_prefix(3);  // the mark of UTF-8
  if (line.starts_with('#')) line.remove_prefix(1);             // as numpy writes it
  CsvHeader header;
  for (const char separator : {',', ';', '\t'})
    if (line.find(separator) != line.npos) {
      header.separator = separator;
      break;
    }
  for (const std::string_view name : csv_cells(line, header.separator)) header.names.emplace_back(name);
  if (header.names.size() > kMostColumns)
    return Error{formatted("expected at most %zu columns, got %zu", kMostColumns, header.names.size())};
  HeaderReader reader(header);
  for (std::size_t i = 0; i < header.names.size(); ++i)
    if (Result<void> taken = reader.take(i); !taken) return taken.failure();
  if (Result<void> complete = reader.complete(); !complete) return complete.failure();
  return header;
}

}  // namespace robot::truth
