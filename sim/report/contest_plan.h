// The number of games that an answer needs, estimated from a pilot run.
#pragma once

#include <string>

#include "sim/report/contest_report.h"

namespace sim::report {

Json plan_json(const ContestReport& pilot);
std::string plan_text(const ContestReport& pilot);

}  // namespace sim::report
