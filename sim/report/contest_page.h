// A comparison as one HTML page: a single file without scripts and without links to other files.
#pragma once

#include <string>

#include "sim/report/game_report.h"

namespace sim::report {

/// Returns the page for the JSON of to_whole_json(report). Each figure on the page is a figure of that JSON.
std::string page_of(const Json& report);

}  // namespace sim::report
