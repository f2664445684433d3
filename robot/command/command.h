// The base of a program's commands, for foresight-lab and foresight-sim: one command is one class in one file.
#pragma once

#include <CLI/CLI.hpp>
#include <cstdio>
#include <memory>
#include <string>
#include <vector>

namespace robot::command {

/// Exit statuses of all commands.
inline constexpr int kDone = 0, kBadInput = 2;

/// Prints "<program>: <sentence>" on stderr and returns kBadInput.
inline int fail(const char* program, const std::string& sentence) {
  std::fprintf(stderr, "%s: %s\n", program, sentence.c_str());
  return kBadInput;
}

/// One subcommand of a program. Its constructor declares the options, run() does the work.
class Command {
 public:
  virtual ~Command() = default;
  Command(const Command&) = delete;
  Command& operator=(const Command&) = delete;

  /// Runs the command with the parsed options and returns the exit status. Called once at most.
  virtual int run() = 0;

  /// Returns whether the command line names this command. Valid after parsing.
  bool chosen() const { return subcommand_->parsed(); }

 protected:
  explicit Command(CLI::App* subcommand) : subcommand_(subcommand) {}

  CLI::App& options() { return *subcommand_; }

 private:
  CLI::App* subcommand_;  // owned by the program's CLI::App
};

using Commands = std::vector<std::unique_ptr<Command>>;

/// Parses the command line and runs the command that it names. Returns the exit status: that of the command, kDone
/// after --help or --version, or kBadInput after a usage error, which CLI11 prints.
inline int run(CLI::App& app, const Commands& commands, int argc, const char* const* argv) {
  try {
    app.parse(argc, argv);
  } catch (const CLI::ParseError& error) {
    return app.exit(error) == 0 ? kDone : kBadInput;
  }
  try {
    for (const auto& command : commands)
      if (command->chosen()) return command->run();
  } catch (const std::exception& exception) {  // of a library: no memory, no threads
    std::fprintf(stderr, "%s: %s\n", app.get_name().c_str(), exception.what());
  }
  return kBadInput;
}

}  // namespace robot::command
