// A comparison as one HTML page: a file to open, keep and send, without scripts and external resources.
#pragma once

#include <string>

#include "sim/report/game_report.h"

namespace sim::report {

/// Returns the page of a to_whole_json(report). Each figure on the page is one of that JSON.
std::string page_of(const Json& report);

}  // namespace sim::report
