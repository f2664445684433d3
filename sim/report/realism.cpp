#include "sim/report/realism.h"

#include <algorithm>
#include <cmath>
#include <cstdio>

#include "robot/core/json_library.h"

namespace sim::report {
namespace {

std::string number(double value, bool known = true) {
  char text[40];
  std::snprintf(text, sizeof text, std::abs(value) < 0.1 ? "%.3f" : "%.2f", value);
  return known && std::isfinite(value) ? text : "–";
}

std::string with_unit(const io::RealFigure& real) {
  return real.about + (real.unit.empty() ? "" : " [" + real.unit + "]");
}

/// Appends blanks up to `width` characters; UTF-8.
std::string padded(const std::string& text, std::size_t width) {
  const auto characters = static_cast<std::size_t>(
      std::ranges::count_if(text, [](char c) { return (static_cast<unsigned char>(c) & 0xc0) != 0x80; }));
  return text + std::string(width > characters ? width - characters : 0, ' ');
}

Json number_or_null(double value) { return std::isfinite(value) ? Json(value) : Json(); }

}  // namespace

std::size_t Realism::inside() const {
  return static_cast<std::size_t>(std::ranges::count(rows, std::optional(true), &RealismRow::inside));
}

std::size_t Realism::judged() const {
  return static_cast<std::size_t>(
      std::ranges::count_if(rows, [](const RealismRow& row) { return row.inside.has_value(); }));
}

Realism realism_of(const std::vector<statistics::Figures>& windows, const io::RealGames& real, std::string measured) {
  // the values of each figure in all windows that have it
  std::vector<std::vector<double>> values(real.figures.size());
  for (const statistics::Figures& figures : windows) {
    std::size_t next = 0;
    statistics::Figures::visit(figures, [&](const char*, double value, const char*, const char*) {
      std::vector<double>& all = values[next++];
      if (std::isfinite(value)) all.push_back(value);
    });
  }

  Realism realism{.name = real.name, .measured = std::move(measured), .windows = windows.size(), .rows = {}};
  for (std::size_t i = 0; i < real.figures.size(); ++i) {
    RealismRow row{
        .real = real.figures[i], .measured = contest::mean_of(values[i]), .windows = values[i].size(), .inside = {}};
    if (row.real.interval && row.windows > 0)
      row.inside = row.real.interval->low <= row.measured.mean && row.measured.mean <= row.real.interval->high;
    realism.rows.push_back(std::move(row));
  }
  return realism;
}

Json to_json(const Realism& realism) {
  Json figures = Json::object();
  for (const RealismRow& row : realism.rows) {
    const auto& interval = row.real.interval;
    const bool known = row.windows > 0;
    figures[row.real.key] = {{"about", row.real.about},
                             {"unit", row.real.unit},
                             {"real",
                              {{"mean", row.real.mean},
                               {"low", interval ? Json(interval->low) : Json()},
                               {"high", interval ? Json(interval->high) : Json()},
                               {"source", row.real.source}}},
                             {"measured",
                              {{"mean", known ? number_or_null(row.measured.mean) : Json()},
                               {"standard_error", row.windows > 1 ? Json(row.measured.error) : Json()},
                               {"windows", row.windows}}},
                             {"inside", row.inside ? Json(*row.inside) : Json()}};
  }
  return {{"real", realism.name},       {"measured", realism.measured}, {"windows", realism.windows},
          {"inside", realism.inside()}, {"judged", realism.judged()},   {"figures", std::move(figures)}};
}

std::string to_text(const Realism& realism) {
  std::string text = padded("figure", 52) + padded("real", 24) + padded(realism.measured, 18) + "inside\n";
  for (const RealismRow& row : realism.rows) {
    const auto& interval = row.real.interval;
    const bool known = row.windows > 0;
    text += padded(with_unit(row.real), 52);
    text += padded(
        number(row.real.mean) + (interval ? " [" + number(interval->low) + ", " + number(interval->high) + "]" : ""),
        24);
    text += padded(number(row.measured.mean, known) + (row.windows > 1 ? " ± " + number(row.measured.error) : ""), 18);
    text += !row.inside ? "–\n" : *row.inside ? "yes\n" : "no\n";
  }
  text += "\n" + std::to_string(realism.inside()) + " of " + std::to_string(realism.judged()) +
          " figures lie inside the interval of real games (" + realism.name + "); " + std::to_string(realism.windows) +
          (realism.windows == 1 ? " window" : " windows") + "; ± one standard error\n";
  return text;
}

}  // namespace sim::report
