// The source of a description: embedded in the program by name, or a file by path.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "robot/core/result.h"

namespace sim::io {

inline constexpr std::size_t kMaxFileBytes = 1 << 20;  // of a description

/// A description as text, with its name in errors.
struct Source {
  std::string text;
  std::string called;  // "models 'match'"
};

/// Returns the names of the embedded files of that kind ("drills", "games", "models", …),
/// ascending.
std::vector<std::string_view> names_of(std::string_view kind);

/// Returns whether an embedded file of that kind has this name.
bool is_embedded(std::string_view kind, std::string_view name);

/// Returns whether `name` is a path: it contains '/' or ends in ".json". Otherwise it is an embedded name.
bool is_path(std::string_view name);

/// Returns the Error for a name that is not among `known`. It names a similar one, or else lists all: "no models 'mach';
/// did you mean 'match'?", "no models 'x'; there are: friendly, match, perfect".
robot::Error unknown_name(std::string_view noun, std::string_view name, const std::vector<std::string_view>& known);

/// Finds the description. The Error for an unknown name is unknown_name(). `noun` is the word for the kind in that
/// sentence.
robot::Result<Source> find_source(std::string_view kind, std::string_view noun, const std::string& name);

/// Returns "a, b, c".
std::string listed(const std::vector<std::string_view>& names);

}  // namespace sim::io
