#include "robot/app/fit/report_page.h"

#include <utility>
#include <vector>

#include "robot/core/text.h"
#include "sim/report/page.h"
#include "sim/report/plot.h"

namespace robot::app {
namespace {

using sim::report::escaped, sim::report::Plot;

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
  return points;
}

void draw_mark(Plot& plot, const fit::Mark& mark) {
  const char* const style = style_of(mark.role);
  switch (mark.shape) {
    case fit::Mark::Shape::dots: plot.dots(style, points_of(mark)); break;
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
    keys += formatted("<span class=\"key %s %s\"></span>", key_of(mark.shape), style_of(mark.role));
    keys += escaped(mark.label);
  }
  return "<figure class=\"card\"><figcaption><b>" + escaped(picture.title) + "</b><br>" + escaped(picture.y_label) +
         keys + "</figcaption>" + plot.svg(escaped(picture.title), escaped(picture.x_label)) + "</figure>\n";
}

std::string row_of(const char* cell, const std::vector<std::string>& words) {
  std::string row = "<tr>";
  for (const std::string& word : words) row += formatted("<%s>%s</%s>", cell, escaped(word).c_str(), cell);
  return row + "</tr>\n";
}

std::string results_part(const fit::Results& results) {
  std::string part =
      "<div class=\"card wide\"><b>" + escaped(results.title) + "</b><table>\n" + row_of("th", results.head);
  for (const auto& row : results.rows) part += row_of("td", row);
  return part + "</table></div>\n";
}

}  // namespace

std::string part_of(const fit::Report& report) {
  std::string part = "<h2 id=\"" + report.name + "\">" + escaped(report.title) + "</h2>\n<div class=\"plots\">\n";
  for (const fit::Picture& picture : report.pictures) part += picture_part(picture);
  part += "</div>\n";
  for (const std::string& note : report.notes) part += "<p class=\"soft\">" + escaped(note) + "</p>\n";
  for (const fit::Results& results : report.results) part += results_part(results);
  return part;
}

}  // namespace robot::app
