// What the moment at which a rollout ends is worth, as JSON: {"name", "about", "reach": 60, "worth": [[own, others'], …]}.
#pragma once

#include <string>
#include <string_view>

#include "robot/core/result.h"
#include "sim/foresight/outlook.h"

namespace sim::io {

robot::Result<foresight::Outlook> parse_outlook(std::string_view text, const std::string& called);

/// The one fitted to games by these rules (a name, with or without changes). Of rules from a file it is that of no worth:
/// nothing was fitted to them.
robot::Result<foresight::Outlook> load_outlook(const std::string& rules);

/// What parse_outlook reads back.
std::string print_outlook(const foresight::Outlook& outlook, const std::string& name, const std::string& about);

}  // namespace sim::io
