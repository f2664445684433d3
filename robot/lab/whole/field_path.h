// The place of one value in the messages of a topic.
#pragma once

#include <cstddef>
#include <string>
#include <string_view>
#include <utility>
#include <variant>
#include <vector>

#include "robot/core/result.h"

namespace robot::lab {

/// Selects the entry of a list whose fields have these numbers: [team=14,player=2].
using EntryFilter = std::vector<std::pair<std::string, double>>;

/// A step into a message: the name of a field, the index in a list, or a filter.
using FieldStep = std::variant<std::string, std::size_t, EntryFilter>;

/// The steps from a message to one of its values, as the viewer writes them: "x", "robots[0].detection.distance",
/// "robots[team=14,player=2].x".
using FieldPath = std::vector<FieldStep>;

/// Parses a path that begins with a name. Returns an Error if `text` is something else or has more than 16 steps.
Result<FieldPath> parse_field_path(std::string_view text);

}  // namespace robot::lab
