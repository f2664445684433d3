// The rules of a year as JSON: sim/data/rules/*.json and what users make of them.
//
// A file has a name, the field, what happens to a ball that is out ("placed_back" or "set_play"), and an entry for each
// other field of field::Rules.
#pragma once

#include <string>
#include <string_view>

#include "robot/core/result.h"
#include "sim/field/rules.h"

namespace sim::io {

/// By the name of an embedded file, or by path; then how many play and what else shall differ:
/// "spl2025:7,half_duration=60,field.length=8".
robot::Result<field::Rules> load_rules(const std::string& name);

/// The rules described in `text`; `called` opens the sentence of an Error ("rules 'spl2012'").
robot::Result<field::Rules> parse_rules(std::string_view text, const std::string& called);

/// A description without sources that reads back identically.
std::string print_rules(const field::Rules& rules, const std::string& name);

}  // namespace sim::io
