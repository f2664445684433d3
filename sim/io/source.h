// Where a description comes from: by name out of the program, or by path from a file.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "robot/core/result.h"

namespace sim::io {

inline constexpr std::size_t kMaxFileBytes = 1 << 20;  // of a description

/// A description as text, and what errors call it.
struct Source {
  std::string text;
  std::string called;  // "models 'match'"
};

/// The names of the embedded files of that kind ("models", "outlooks", "rules", "strategies"), ascending.
std::vector<std::string_view> names_of(std::string_view kind);

/// What contains a '/' or ends in ".json" is the path of a file, anything else the name of an embedded one.
bool is_path(std::string_view name);

/// Finds it. An unknown name is answered with those there are: "no models 'mach'; there are: friendly, match, perfect".
/// `noun` is how a sentence calls one of that kind.
robot::Result<Source> find_source(std::string_view kind, std::string_view noun, const std::string& name);

/// "a, b, c"
std::string listed(const std::vector<std::string_view>& names);

}  // namespace sim::io
