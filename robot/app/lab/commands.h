// The commands of foresight-lab, one per file.
#pragma once

#include <memory>
#include <string>

#include "robot/command/command.h"

namespace robot::app {

using command::Command, command::kDone;

/// Prints the sentence on stderr and returns the exit status of bad input.
inline int fail(const std::string& sentence) { return command::fail("foresight-lab", sentence); }

std::unique_ptr<Command> calibrate_command(CLI::App& app);
std::unique_ptr<Command> fit_command(CLI::App& app);
std::unique_ptr<Command> game_statistics_command(CLI::App& app);
std::unique_ptr<Command> import_command(CLI::App& app);
std::unique_ptr<Command> info_command(CLI::App& app);
std::unique_ptr<Command> plan_fit_command(CLI::App& app);
std::unique_ptr<Command> play_command(CLI::App& app);
std::unique_ptr<Command> relay_command(CLI::App& app);
std::unique_ptr<Command> redecide_command(CLI::App& app);
std::unique_ptr<Command> situation_command(CLI::App& app);
std::unique_ptr<Command> what_if_command(CLI::App& app);
std::unique_ptr<Command> smooth_command(CLI::App& app);
std::unique_ptr<Command> synthesize_command(CLI::App& app);
std::unique_ptr<Command> truth_command(CLI::App& app);

}  // namespace robot::app
