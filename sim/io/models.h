// Models of reality as JSON: sim/data/models/*.json and what users make of them.
//
// A file has a name and one section per struct of sim::Models; an entry is a value or {"value", "unit", "source"}.
// With "based_on" it says only what differs from that one; a kick is known by its name there.
#pragma once

#include <string>
#include <string_view>

#include "robot/core/result.h"
#include "sim/match/params.h"

namespace sim::io {

/// By the name of an embedded file, or by path; then what shall differ, an effect or any field:
/// "match,falls=on,walk.forward=0.2". The models are called what the file calls itself, and what differs.
robot::Result<Models> load_models(const std::string& name);

/// The models described in `text`; `called` opens the sentence of an Error ("models 'match'").
robot::Result<Models> parse_models(std::string_view text, const std::string& called);

/// A description without sources that reads back identically.
std::string print_models(const Models& models);

}  // namespace sim::io
