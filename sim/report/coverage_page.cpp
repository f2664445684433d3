#include <algorithm>
#include <cmath>

#include "robot/core/text.h"
#include "sim/report/coverage_report.h"
#include "sim/report/page.h"

namespace sim::report {
namespace {

using debug::MeanGain, debug::Part, debug::Visits;
using robot::formatted;

constexpr const char* kCoverageStyle = R"(
h2 { font-size: 18px; margin: 26px 0 8px; } .card { padding: 10px 16px; overflow-x: auto; }
th, td { padding: 3px 14px 3px 0; text-align: right; white-space: nowrap; }
th:first-child, td:first-child { text-align: left; } .tree td:first-child { padding: 0; }
.part { display: flex; min-height: 28px; align-items: center; }
.part i { align-self: stretch; width: 17px; border-left: 1px solid var(--line); flex: none; }
.name { padding: 2px 9px; border-radius: 5px; margin: 2px 0; white-space: normal; max-width: 46ch;
  background: color-mix(in srgb, var(--blue) calc(1% * var(--heat)), transparent); }
.skill { color: var(--soft); font-size: 13px; margin-left: 8px; } .never .name { border: 1px dashed var(--soft); }
.never td, .never .name { color: var(--soft); } svg { display: block; width: 150px; height: 22px; }
.axis { stroke: var(--line); } .good { stroke: var(--good); fill: var(--good); } .bad { stroke: var(--bad); fill: var(--bad); }
.even { stroke: var(--soft); fill: var(--soft); }
)";

constexpr double kGainWidth = 150, kGainMiddle = 11;  // [px]

/// Returns the largest gain with its interval of the parts whose interval is not wider than the scale of the others.
double scale_of(const CoverageReport& report) {
  double most = 0.01;
  for (const Visits& visits : report.coverage.parts)
    if (visits.decisions > 0) most = std::max(most, std::abs(gain_of(visits, report.coverage.games).mean));
  return 1.25 * most;
}

/// Draws the gain as a dot and its interval as a line, with 0 in the middle.
std::string gain_drawing(const MeanGain& gain, double scale) {
  const auto x = [&](double value) { return kGainWidth / 2 * (1 + std::clamp(value / scale, -1., 1.)); };
  const double low = gain.mean - gain.half_width, high = gain.mean + gain.half_width;
  const char* style = low > 0 ? "good" : high < 0 ? "bad" : "even";
  std::string all =
      formatted("<svg viewBox=\"0 0 %.0f 22\" role=\"img\" aria-label=\"%+.3f goals\">", kGainWidth, gain.mean);
  all += formatted("<line class=\"axis\" x1=\"%.0f\" x2=\"%.0f\" y1=\"1\" y2=\"21\"/>", kGainWidth / 2, kGainWidth / 2);
  if (std::isfinite(gain.half_width))
    all += formatted("<line class=\"%s\" x1=\"%.1f\" x2=\"%.1f\" y1=\"%.0f\" y2=\"%.0f\" stroke-width=\"2\"/>", style,
                     x(low), x(high), kGainMiddle, kGainMiddle);
  return all +
         formatted("<circle class=\"%s\" cx=\"%.1f\" cy=\"%.0f\" r=\"4\"/></svg>", style, x(gain.mean), kGainMiddle);
}

std::string part_row(const CoverageReport& report, std::size_t number, double scale) {
  const Part& part = report.parts.all()[number];
  const Visits& visits = report.coverage.parts[number];
  const bool never = visits.decisions == 0;
  std::string row = never ? "<tr class=\"never\">" : "<tr>";
  row += "<td><div class=\"part\">";
  for (int i = 0; i < part.depth; ++i) row += "<i></i>";
  // a part of a hundredth of the time is still seen
  const double share = report.time_share(number), heat = part.depth == 0 ? 0 : 70 * std::sqrt(share);
  row += formatted("<span class=\"name\" style=\"--heat: %.1f\">", heat) + escaped(part.name) + "</span>";
  if (!part.skill.empty() && part.skill != part.name) row += "<span class=\"skill\">" + escaped(part.skill) + "</span>";
  row += "</div></td>";
  if (never) return row + "<td colspan=\"6\">never reached</td></tr>\n";
  const MeanGain gain = gain_of(visits, report.coverage.games);
  const double stays = static_cast<double>(visits.stays);
  row += formatted("<td>%.2f %%</td><td>%.1f</td><td>%.2f s</td><td>%.0f %%</td>", 100 * share,
                   stays / static_cast<double>(report.coverage.games),
                   static_cast<double>(visits.ticks) * static_cast<double>(kTickDuration) / stays,
                   100 * static_cast<double>(visits.interrupted) / stays);
  row += std::isfinite(gain.half_width) ? formatted("<td>%+.3f ± %.3f</td>", gain.mean, gain.half_width)
                                        : formatted("<td>%+.3f</td>", gain.mean);
  return row + "<td>" + gain_drawing(gain, scale) + "</td></tr>\n";
}

}  // namespace

std::string page_of(const CoverageReport& report) {
  const std::string title = "What " + report.parts.tree().name + " does";
  std::string all = "<h1>" + escaped(title) + "</h1>\n";
  all +=
      "<p class=\"soft\">The tree " + escaped(report.about) +
      ". The colour of a part grows with its share of the time. Broken: stays that began less than half a second after "
      "the last one. Goals: own minus theirs within 30 s after a decision, with the 95 % interval.</p>\n"
      "<div class=\"card\"><table class=\"tree\">\n<tr><th>part</th><th>time</th><th>stays a game</th><th>mean "
      "stay</th>"
      "<th>broken</th><th>goals within 30 s</th><th></th></tr>\n";
  const double scale = scale_of(report);
  for (std::size_t i = 0; i < report.parts.all().size(); ++i) all += part_row(report, i, scale);
  all += "</table></div>\n";
  if (const std::vector<std::size_t> same = report.always_same(); !same.empty()) {
    all +=
        "<h2>Comparisons with always the same answer</h2>\n<div class=\"card\"><table>\n"
        "<tr><th>comparison</th><th>answer</th><th>times</th></tr>\n";
    for (const std::size_t node : same) {
      const debug::Asked& asked = report.coverage.comparisons[node];
      all += "<tr><td>" + escaped(report.parts.tree().node_words[node].condition) + "</td><td>" +
             (asked.yes > 0 ? "yes" : "no") +
             formatted("</td><td>%lld</td></tr>\n", static_cast<long long>(asked.times()));
    }
    all += "</table></div>\n";
  }
  return html_page(title, kCoverageStyle, all);
}

}  // namespace sim::report
