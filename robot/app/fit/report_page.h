// The part of a page that shows a report of a fit.
#pragma once

#include <string>
#include <utility>
#include <vector>

#include "robot/fit/report.h"

namespace robot::app {

/// The styles of the marks in pictures, for the page's style sheet.
inline constexpr const char* kMarkStyle = R"(
:root { --truth: #1769d2; --robot: #d97706; --other: #8b95a5; }
@media (prefers-color-scheme: dark) { :root { --truth: #6aa8ff; --robot: #f5a742; --other: #7d8796; } }
.truth { fill: var(--truth); color: var(--truth); opacity: .55; } .robot { fill: var(--robot); color: var(--robot); opacity: .55; }
.other { fill: var(--other); color: var(--other); opacity: .55; } .fitted { fill: var(--ink); color: var(--ink); }
polyline { fill: none !important; opacity: 1 !important; stroke: currentColor; stroke-width: 2; }
polyline.other { stroke-width: 1.5; stroke-dasharray: 5 4; } polygon { opacity: .16 !important; stroke: none; }
.few circle { r: 3.2px; } .words { text-align: left !important; } .outside { color: var(--bad); font-weight: 600; text-align: left !important; }
.even { color: var(--other); } polyline.few circle { r: 3.2px; } .words { text-align: left !important; } .outside { color: var(--bad); font-weight: 600; text-align: left !important; }
.even { stroke-width: 1; } circle.end { display: none; }
.key { display: inline-block; width: 11px; height: 11px; border-radius: 6px; margin: 0 5px 0 12px; background: currentColor; }
.key.line { height: 2px; width: 20px; vertical-align: middle; border-radius: 0; opacity: 1; }
.item { white-space: nowrap; } .key.bars { border-radius: 2px; } .key.band { opacity: .3; border-radius: 2px; }
)";

/// Returns at most 2000 of the dots, evenly chosen: more are neither seen nor quickly drawn.
std::vector<std::pair<double, double>> thinned(std::vector<std::pair<double, double>> dots);

/// Returns the part as HTML: title, pictures, notes, results.
std::string part_of(const fit::Report& report);

}  // namespace robot::app
