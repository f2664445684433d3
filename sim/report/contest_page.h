// A comparison as one page: a file to be opened, kept and sent, without scripts and without anything from elsewhere.
#pragma once

#include <string>

#include "sim/report/game_report.h"

namespace sim::report {

/// From what to_whole_json(report) says: each figure on the page is one of its.
std::string page_of(const Json& report);

}  // namespace sim::report
