// The value of the last moment of a rollout, as JSON: {"name", "about", "reach": 60, "worth": [[own, others'], …]}.
#pragma once

#include <string>
#include <string_view>

#include "robot/core/result.h"
#include "sim/foresight/outlook.h"

namespace sim::io {

robot::Result<foresight::Outlook> parse_outlook(std::string_view text, const std::string& called);

/// Loads the outlook fitted to games by these rules (a name, with or without changes). For rules from a file all values
/// are 0, because no fit exists.
robot::Result<foresight::Outlook> load_outlook(const std::string& rules);

/// Returns a description that parse_outlook reads back.
std::string print_outlook(const foresight::Outlook& outlook, const std::string& name, const std::string& about);

}  // namespace sim::io
