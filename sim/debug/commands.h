// The commands of the debugger, for help and completion.
#pragma once

#include <span>
#include <string>
#include <string_view>

#include "robot/core/result.h"

namespace sim::debug {

/// A row of the help.
struct CommandInfo {
  std::string_view name;
  std::string_view usage;
  std::string_view about;
};

/// All commands.
std::span<const CommandInfo> commands();
/// Returns the help, a line per command.
std::string help_text();

/// Returns the sentence for a command with wrong words.
robot::Error usage(std::string_view name);

}  // namespace sim::debug
