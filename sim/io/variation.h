// The name of a description with changes, as typed: "match,falls=on,walk.forward=0.2".
#pragma once

#include <string>
#include <vector>

#include "robot/core/json_library.h"
#include "robot/core/result.h"
#include "sim/io/json.h"

namespace sim::io {

struct Variation {
  std::string name;  // of the description, or its path
  Json number;       // behind a colon: 7 of "spl2025:7"; null: none
  Json changes;      // in the form of a description: {"falls": true, "walk": {"forward": 0.2}}
};

/// Parses `text`. Values are numbers, texts, on or true, off or false; otherwise it returns an Error.
robot::Result<Variation> parse_variation(const std::string& text, const std::string& called);

}  // namespace sim::io
