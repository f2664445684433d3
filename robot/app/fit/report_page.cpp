#include "robot/app/fit/report_page.h"

#include <utility>
#include <vector>

#include "robot/core/text.h"
#include "sim/report/page.h"
#include "sim/report/plot.h"

namespace robot::app {
namespace {

using sim::report::escaped, sim::report::Plot;

constexpr std::size_t kFewDots = 60;  // up to here they are drawn larger

const char* style_of(fit::Mark::Role role) {
  switch (role) {
    case fit::Mark::Role::truth: return "truth";
    case fit::Mark::Role::robot: return "robot";
    case fit::Mark::Role::fitted: return "fitted";
    case fit::Mark::Role::other: return "other";
  }
  return "other";
}

const char* key_of(fit::Mark::Shape shape) {
  switch (shape) {
    case fit::Mark::Shape::dots: return "dots";
    case fit::Mark::Shape::line: return "line";
    case fit::Mark::Shape::band: return "band";
    case fit::Mark::Shape::bars: return "bars";
  }
  return "dots";
}

std::vector<std::pair<double, double>> points_of(const fit::Mark& mark) {
  std::vector<std::pair<double, double>> points;
  for (std::size_t i = 0; i < mark.x.size(); ++i) points.emplace_back(mark.x[i], mark.y[i]);
  return mark.shape == fit::Mark::Shape::dots ? thinned(std::move(points)) : points;
}

void draw_mark(Plot& plot, const fit::Mark& mark) {
  const char* const style = style_of(mark.role);
  switch (mark.shape) {
    case fit::Mark::Shape::dots:
      plot.dots(std::string(style) + (mark.x.size() <= kFewDots ? " few" : ""), points_of(mark));
      break;
    case fit::Mark::Shape::line: plot.line(style, points_of(mark)); break;
    case fit::Mark::Shape::band: plot.band(style, mark.x, mark.y, mark.high); break;
    case fit::Mark::Shape::bars:
      for (std::size_t i = 0; i < mark.x.size(); ++i)
        if (mark.y[i] > 0) plot.bar(style, mark.x[i], mark.x[i] + mark.width, mark.y[i], formatted("%.4g", mark.y[i]));
      break;
  }
}

std::string picture_part(const fit::Picture& picture) {
  Plot plot(picture.axes.left, picture.axes.right, picture.axes.bottom, picture.axes.top);
  std::string keys;
  for (const fit::Mark& mark : picture.marks) {
    draw_mark(plot, mark);
    if (mark.label.empty()) continue;
    keys += formatted("<span class=\"item\"><span class=\"key %s %s\"></span>%s</span> ", key_of(mark.shape),
                      style_of(mark.role), escaped(mark.label).c_str());
  }
  return "<figure class=\"card\"><figcaption><b>" + escaped(picture.title) + "</b><br>" + escaped(picture.y_label) +
         keys + "</figcaption>" + plot.svg(escaped(picture.title), escaped(picture.x_label)) + "</figure>\n";
}

/// Returns the words as a sentence of the page. A name such as "noise.pixels" at its begin stays as it is.
std::string sentence(const std::string& words) {
  std::string text = escaped(words);
  if (text.substr(0, text.find(' ')).find('.') != std::string::npos) return text;
  if (!text.empty() && text[0] >= 'a' && text[0] <= 'z') text[0] = static_cast<char>(text[0] - 'a' + 'A');
  return text;
}

std::string row_of(const char* cell, const fit::Results& results, const std::vector<std::string>& words) {
  std::string row = "<tr>";
  for (std::size_t i = 0; i < words.size(); ++i) {
    const char* const style = words[i] == "OUTSIDE"  ? " class=\"outside\""
                              : results.has_words(i) ? " class=\"words\""
                                                     : "";
    row += formatted("<%s%s>%s</%s>", cell, style, escaped(words[i]).c_str(), cell);
  }
  return row + "</tr>\n";
}

std::string results_part(const fit::Results& results) {
  const char* const span = results.head.size() > 7 ? " whole" : "";
  std::string part = formatted("<div class=\"card wide%s\"><b>", span) + sentence(results.title) + "</b><table>\n" +
                     row_of("th", results, results.head);
  for (const auto& row : results.rows) part += row_of("td", results, row);
  return part + "</table></div>\n";
}

}  // namespace

std::vector<std::pair<double, double>> thinned(std::vector<std::pair<double, double>> dots) {
  constexpr std::size_t kMost = 2000;
  if (dots.size() <= kMost) return dots;
  std::vector<std::pair<double, double>> some;
  for (std::size_t i = 0; i < kMost; ++i) some.push_back(dots[i * dots.size() / kMost]);
  return some;
}

std::string part_of(const fit::Report& report) {
  std::string part = "<h2 id=\"" + report.name + "\">" + escaped(report.title) + "</h2>\n<div class=\"plots\">\n";
  for (const fit::Picture& picture : report.pictures) part += picture_part(picture);
  part += "</div>\n";
  for (const std::string& note : report.notes) part += "<p class=\"soft\">" + sentence(note) + "</p>\n";
  part += "<div class=\"tables\">\n";
  for (const fit::Results& results : report.results) part += results_part(results);
  return part + "</div>\n";
}

}  // namespace robot::app
