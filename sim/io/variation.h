// A description by name with what shall differ from it, as one types it: "match,falls=on,walk.forward=0.2".
#pragma once

#include <string>
#include <vector>

#include "robot/core/result.h"
#include "sim/io/json.h"

namespace sim::io {

struct Variation {
  std::string name;  // of the description, or its path
  Json number;       // behind a colon: 7 of "spl2025:7"; null: none
  Json changes;      // as a description would say them: {"falls": true, "walk": {"forward": 0.2}}
};

/// Takes `text` apart. Values are numbers, texts, on or true, off or false. An Error if there is none of these.
robot::Result<Variation> parse_variation(const std::string& text, const std::string& called);

}  // namespace sim::io
