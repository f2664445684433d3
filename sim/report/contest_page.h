// A comparison as one HTML page: a single file without scripts, which needs no other file.
#pragma once

#include <string>
#include <vector>

#include "sim/report/game_report.h"

namespace sim::report {

/// Returns the page for the JSON of to_whole_json(report). Each figure on the page is a figure of that JSON. A decisive pair
/// with a "game" gets a link to that recording beside the page.
std::string page_of(const Json& report);

/// Returns the decisive pairs of `report` that the page shows, the one with the largest gain first. They point into it.
std::vector<Json*> shown_pairs(Json& report);

}  // namespace sim::report
