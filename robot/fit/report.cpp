#include "robot/fit/report.h"

#include <algorithm>
#include <cctype>
#include <cmath>

#include "robot/core/text.h"

namespace robot::fit {
namespace {

char sign_of(Mark::Role role) {
  switch (role) {
    case Mark::Role::truth: return '.';
    case Mark::Role::robot: return 'o';
    case Mark::Role::fitted: return '#';
    case Mark::Role::other: return '-';
  }
  return '.';
}

/// Draws a straight piece with as many signs as the plot has columns.
void draw_piece(TextPlot& plot, const Mark& mark, std::size_t from, const TextPlot::Axes& axes) {
  const double dx = mark.x[from + 1] - mark.x[from], dy = mark.y[from + 1] - mark.y[from];
  const double across = std::abs(dx) / (axes.right - axes.left) * TextPlot::kWidth;
  const double up = std::abs(dy) / (axes.top - axes.bottom) * TextPlot::kHeight;
  const int pieces = static_cast<int>(std::clamp(std::max(across, up), 1., 4. * TextPlot::kWidth));
  for (int i = 0; i <= pieces; ++i)
    plot.dot(sign_of(mark.role), mark.x[from] + dx * i / pieces, mark.y[from] + dy * i / pieces);
}

void draw(TextPlot& plot, const Mark& mark, const TextPlot::Axes& axes) {
  switch (mark.shape) {
    case Mark::Shape::dots:
      for (std::size_t i = 0; i < mark.x.size(); ++i) plot.dot(sign_of(mark.role), mark.x[i], mark.y[i]);
      break;
    case Mark::Shape::line:
      for (std::size_t i = 0; i + 1 < mark.x.size(); ++i) draw_piece(plot, mark, i, axes);
      break;
    case Mark::Shape::band: break;  // a terminal shows the line in it
    case Mark::Shape::bars: {
      const double step = (axes.top - axes.bottom) / TextPlot::kHeight;
      for (std::size_t i = 0; i < mark.x.size(); ++i)
        for (double y = axes.bottom; y < mark.y[i]; y += step)
          plot.dot(sign_of(mark.role), mark.x[i] + mark.width / 2, y);
      break;
    }
  }
}

std::string text_of(const Results& results) {
  std::vector<std::size_t> widths(results.head.size());
  const auto widen = [&](const std::vector<std::string>& row) {
    for (std::size_t i = 0; i < row.size(); ++i) widths[i] = std::max(widths[i], row[i].size());
  };
  widen(results.head);
  for (const auto& row : results.rows) widen(row);
  std::string text = results.title + '\n';
  // words to the left, numbers to the right
  const auto add = [&](const std::vector<std::string>& row) {
    for (std::size_t i = 0; i < row.size(); ++i)
      text += formatted(results.has_words(i) ? "  %-*s" : "  %*s", static_cast<int>(widths[i]), row[i].c_str());
    text += '\n';
  };
  add(results.head);
  for (const auto& row : results.rows) add(row);
  return text;
}

}  // namespace

bool Results::has_words(std::size_t column) const {
  const std::string& first = rows.empty() ? head[column] : rows.front()[column];
  return !first.empty() && std::isalpha(static_cast<unsigned char>(first.front())) != 0;
}

const Figure* Report::figure(const std::string& figure_name) const {
  const auto found = std::ranges::find(figures, figure_name, &Figure::name);
  return found == figures.end() ? nullptr : &*found;
}

Need need_of(const Figure& figure, double wanted, const std::string& advice) {
  const double half = (figure.high - figure.low) / 2;
  const auto enough = static_cast<std::size_t>(
      std::ceil(static_cast<double>(figure.events) * std::pow(std::min(half / wanted, 1e3), 2)));
  const std::size_t more = enough - std::min(enough, figure.events);
  return {.figure = figure.name,
          .kind = figure.kind,
          .events = figure.events,
          .loose = half,
          .wanted = wanted,
          .unit = figure.unit,
          .more = more,
          .advice = more > 0 ? advice : ""};
}

Need need_of(const std::string& figure, const std::string& kind, std::size_t events, std::size_t enough,
             const std::string& advice) {
  const std::size_t more = enough - std::min(enough, events);
  return {.figure = figure, .kind = kind, .events = events, .unit = "", .more = more, .advice = more > 0 ? advice : ""};
}

std::string to_text(const Picture& picture) {
  TextPlot plot(picture.axes);
  std::string text = picture.title + ": " + picture.y_label + " over " + picture.x_label;
  for (const Mark& mark : picture.marks) {
    if (mark.shape != Mark::Shape::band && !mark.label.empty())
      text += std::string(", ") + sign_of(mark.role) + ' ' + mark.label;
    draw(plot, mark, picture.axes);
  }
  return text + '\n' + plot.text();
}

std::string to_text(const Report& report) {
  std::string text;
  if (!report.pictures.empty()) text += to_text(report.pictures.front());
  for (const Figure& figure : report.figures) text += formatted("%-33s ", figure.name.c_str()) + to_text(figure) + '\n';
  for (const Results& results : report.results) text += text_of(results);
  for (const std::string& note : report.notes) text += note + '\n';
  return text;
}

}  // namespace robot::fit
