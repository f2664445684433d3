// The rules of a year as JSON: sim/data/rules/*.json and what users make of them.
//
// A file has a name, the field, "ball_out" ("placed_back" or "set_play": the rule for a ball that is out), and an entry
// for each other field of field::Rules.
#pragma once

#include <string>
#include <string_view>

#include "robot/core/result.h"
#include "sim/field/rules.h"
#include "sim/io/reader.h"

namespace sim::io {

/// Loads rules by the name of an embedded file, or by path. Behind it may follow the number of players and changes:
/// "spl2025:7,half_duration=60,field.length=8".
robot::Result<field::Rules> load_rules(const std::string& name, Sources* sources = nullptr);

/// Parses the rules described in `text`; `called` opens the sentence of an Error ("rules 'spl2012'").
robot::Result<field::Rules> parse_rules(std::string_view text, const std::string& called, Sources* sources = nullptr);

/// Returns a description that reads back identically, with the sources that loading found.
std::string print_rules(const field::Rules& rules, const std::string& name, const Sources& sources = {});

}  // namespace sim::io
