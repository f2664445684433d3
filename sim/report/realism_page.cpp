#include <algorithm>
#include <cmath>

#include "robot/core/text.h"
#include "sim/report/page.h"
#include "sim/report/realism.h"

namespace sim::report {
namespace {

using robot::formatted;

constexpr const char* kRealismStyle = R"(
:root { --real: #9fc3ee; } @media (prefers-color-scheme: dark) { :root { --real: #2f5485; } }
.card { padding: 10px 16px; overflow-x: auto; } th, td { padding: 4px 14px 4px 0; text-align: left; white-space: nowrap; }
td.number { text-align: right; } td.plot { width: 320px; } svg { display: block; width: 320px; height: 26px; }
.interval { fill: var(--real); } .mean { stroke: var(--ink); stroke-width: 1.5; } .axis { stroke: var(--line); }
.yes { color: var(--good); fill: var(--good); stroke: var(--good); } .no { color: var(--bad); fill: var(--bad); stroke: var(--bad); }
.open { color: var(--open); fill: var(--open); stroke: var(--open); } td.yes, td.no, td.open { stroke: none; }
)";

constexpr double kBarWidth = 320, kBarMiddle = 13;  // [px]

const char* style_of(const RealismRow& row) { return !row.inside ? "open" : *row.inside ? "yes" : "no"; }
const char* verdict_of(const RealismRow& row) {
  return !row.inside ? "not judged" : *row.inside ? "inside" : "outside";
}

/// Draws the real interval as a bar, its mean as a line and the measured mean with its error as a dot. The scale begins
/// at 0.
std::string drawing(const RealismRow& row) {
  const bool known = row.windows > 0;
  double most = row.real.mean;
  if (row.real.interval) most = std::max(most, row.real.interval->high);
  if (known) most = std::max(most, row.measured.mean + row.measured.error);
  const auto x = [&](double value) { return most > 0 ? std::max(0., value) / (1.05 * most) * kBarWidth : 0; };

  std::string all = formatted("<svg viewBox=\"0 0 %.0f 26\" role=\"img\" aria-label=\"%s: %s\">", kBarWidth,
                              escaped(row.real.about).c_str(), verdict_of(row));
  all += formatted("<line class=\"axis\" x1=\"0\" x2=\"%.0f\" y1=\"%.0f\" y2=\"%.0f\"/>", kBarWidth, kBarMiddle,
                   kBarMiddle);
  if (row.real.interval)
    all += formatted("<rect class=\"interval\" x=\"%.1f\" width=\"%.1f\" y=\"5\" height=\"16\" rx=\"3\"/>",
                     x(row.real.interval->low), x(row.real.interval->high) - x(row.real.interval->low));
  all += formatted("<line class=\"mean\" x1=\"%.1f\" x2=\"%.1f\" y1=\"4\" y2=\"22\"/>", x(row.real.mean),
                   x(row.real.mean));
  if (known) {
    all += formatted("<line class=\"%s\" x1=\"%.1f\" x2=\"%.1f\" y1=\"%.0f\" y2=\"%.0f\"/>", style_of(row),
                     x(row.measured.mean - row.measured.error), x(row.measured.mean + row.measured.error), kBarMiddle,
                     kBarMiddle);
    all += formatted("<circle class=\"%s\" cx=\"%.1f\" cy=\"%.0f\" r=\"5\"/>", style_of(row), x(row.measured.mean),
                     kBarMiddle);
  }
  return all + "</svg>";
}

std::string row_of(const RealismRow& row) {
  const bool known = row.windows > 0;
  std::string all = "<tr><td title=\"" + escaped(row.real.source) + "\">" + escaped(row.real.about) +
                    "</td><td class=\"plot\">" + drawing(row) + "</td>";
  all += formatted("<td class=\"number\">%.3g</td>", row.real.mean);
  all += known ? formatted("<td class=\"number\" data-of=\"%s\">%.3g ± %.2g</td>", row.real.key.c_str(),
                           row.measured.mean, row.measured.error)
               : "<td class=\"number\">–</td>";
  all += "<td>" + escaped(row.real.unit) + "</td>";
  return all + formatted("<td class=\"%s\">%s</td></tr>\n", style_of(row), verdict_of(row));
}

}  // namespace

std::string page_of(const Realism& realism, const std::string& about) {
  const std::string headline =
      formatted("%zu of %zu figures lie inside the interval of real games", realism.inside(), realism.judged());
  std::string all = "<h1>" + headline + "</h1>\n";
  all += "<p class=\"soft\">" + escaped(about) + " " +
         formatted(
             "Bar: the interval of real games (%s); line: their mean; dot: the %s mean of %zu windows ± one standard "
             "error.",
             escaped(realism.name).c_str(), escaped(realism.measured).c_str(), realism.windows) +
         "</p>\n<div class=\"card\"><table>\n<tr><th>figure</th><th>drawn from 0</th><th>real</th><th>" +
         escaped(realism.measured) + "</th><th>unit</th><th>verdict</th></tr>\n";
  for (const RealismRow& row : realism.rows) all += row_of(row);
  return html_page(headline, kRealismStyle, all + "</table></div>\n");
}

}  // namespace sim::report
