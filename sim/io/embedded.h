// The files below sim/data, embedded in the program.
#pragma once

#include <span>
#include <string_view>

namespace sim::io {

struct Embedded {
  std::string_view kind;  // the folder: "drills", "games", "models", …
  std::string_view name;  // of the file, without ".json"
  std::string_view text;
};

/// Returns the files by kind and name, ascending. embed.cmake generates the function.
std::span<const Embedded> embedded_files();

}  // namespace sim::io
