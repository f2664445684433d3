// The decisions of a robot as CSV (RFC 4180): one line each, with all that the tree compared.
#pragma once

#include <string>

#include "sim/debug/decision_log.h"

namespace sim::report {

/// Returns the names of the columns: time, skill, role, leaf, and each feature that the tree reads, with its unit.
std::string csv_head(const agent::Tree& tree);
/// Returns the line of a decision. Time counts from the first tick of the game. A value that the robot does not know is
/// empty, and so are leaf and features outside play.
std::string csv_row(const agent::Tree& tree, const debug::LoggedDecision& logged);

}  // namespace sim::report
