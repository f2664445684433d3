// The report of a course of learning: as text, as JSON and as a page.
#pragma once

#include <string>

#include "sim/learn/learning.h"
#include "sim/report/game_report.h"

namespace sim::report {

/// Returns the lessons, the changes and the gate's answer for a terminal.
std::string learn_text(const learn::Course& course);

Json learn_json(const learn::Course& course);

/// Returns the page: the verdict, the changes, the learning curve and the successes of each lesson.
std::string learn_page(const learn::Course& course);

}  // namespace sim::report
