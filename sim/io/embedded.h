// The files below sim/data as part of the program, so that it needs none.
#pragma once

#include <span>
#include <string_view>

namespace sim::io {

struct Embedded {
  std::string_view kind;  // the folder: "models", "outlooks", "rules", "strategies"
  std::string_view name;  // of the file, without ".json"
  std::string_view text;
};

/// By kind and name, ascending. Made by embed.cmake.
std::span<const Embedded> embedded_files();

}  // namespace sim::io
