// Findings as text and JSON.
#pragma once

#include <nlohmann/json_fwd.hpp>
#include <string>
#include <vector>

#include "sim/check/findings.h"

namespace sim::check {

/// A situation and its findings.
struct Checked {
  const Scenario* scenario = nullptr;
  std::vector<Finding> findings;
};

/// Returns whether no finding failed.
bool all_passed(const std::vector<Checked>& all);

/// Returns a table with a line per metric, and a last line with the number of failed ones.
std::string to_text(const std::vector<Checked>& all);
nlohmann::ordered_json to_json(const std::vector<Checked>& all);

}  // namespace sim::check
