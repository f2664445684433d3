#include "sim/io/real_games.h"

#include <cmath>

#include "robot/core/json_library.h"
#include "sim/io/json.h"
#include "sim/io/reader.h"
#include "sim/io/source.h"

namespace sim::io {

using robot::Result;

namespace {

/// Reads the number `name` of an entry, if it has one.
std::optional<double> number_of(Reader& reader, const Json& entry, const std::string& path, const char* name) {
  const auto found = entry.find(name);
  if (found == entry.end()) return std::nullopt;
  if (!found->is_number() || !std::isfinite(found->get<double>())) {
    reader.refuse(Reader::below(path, name) + " must be a number, got " + shown(*found));
    return std::nullopt;
  }
  return found->get<double>();
}

void read_figure(Reader& reader, const Json& entry, const std::string& path, RealFigure& figure) {
  if (!reader.is_object(entry, path)) return;
  reader.refuse_unknown(entry, path, {"mean", "low", "high", "unit", "source"});
  const std::string unit = reader.text(entry, path, "unit");
  if (unit != figure.unit) reader.refuse(path + ".unit must be \"" + figure.unit + "\", got \"" + unit + "\"");
  figure.source = reader.text(entry, path, "source");
  const auto mean = number_of(reader, entry, path, "mean");
  const auto low = number_of(reader, entry, path, "low"), high = number_of(reader, entry, path, "high");
  if (!mean) return reader.refuse(path + ".mean is missing, expected a number");
  figure.mean = *mean;
  if (low.has_value() != high.has_value()) reader.refuse(path + " must have both low and high, or neither");
  if (!low || !high) return;
  if (!(*low <= *mean && *mean <= *high)) reader.refuse(path + ": expected low <= mean <= high, got " + shown(entry));
  figure.interval = {.low = *low, .high = *high};
}

}  // namespace

Result<RealGames> parse_real_games(std::string_view text, const std::string& called) {
  const Result<Json> json = parse_object(text, called);
  if (!json) return json.failure();
  Reader reader(called);
  reader.refuse_unknown(*json, "", {"name", "about", "figures"});
  RealGames games{.name = reader.text(*json, "", "name"), .about = reader.text(*json, "", "about"), .figures = {}};
  const Json* figures = reader.find(*json, "figures", Fields::all);
  if (!figures || !reader.is_object(*figures, "figures")) return reader.error();

  std::vector<std::string_view> known;
  const statistics::Figures none;
  statistics::Figures::visit(none, [&](const char* key, double, const char* unit, const char* about) {
    known.push_back(key);
    RealFigure& figure = games.figures.emplace_back();
    figure.key = key, figure.unit = unit, figure.about = about;
    if (const Json* entry = reader.find(*figures, key, Fields::all))
      read_figure(reader, *entry, Reader::below("figures", key), figure);
  });
  reader.refuse_unknown(*figures, "figures", known);
  if (!reader.good()) return reader.error();
  return games;
}

Result<RealGames> load_real_games(const std::string& name) {
  const Result<Source> source = find_source("games", "real games", name);
  if (!source) return source.failure();
  return parse_real_games(source->text, source->called);
}

}  // namespace sim::io
