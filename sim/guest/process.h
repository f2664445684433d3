// A process that answers one line with one line.
#pragma once

#include <sys/types.h>

#include <string>
#include <string_view>

#include "robot/core/files.h"
#include "robot/core/result.h"

namespace sim::guest {

/// The process. The destructor closes its input and kills it if it does not end. Its stderr is ours.
class Process {
 public:
  static constexpr std::size_t kLongestLine = 1 << 16;

  /// Starts a command of the shell.
  static robot::Result<Process> start(const std::string& command);

  Process(Process&& other) noexcept;
  Process& operator=(Process&&) = delete;
  ~Process();

  /// Returns its answer to `line`, without the line's end. Earlier output is not an answer. The Error is the end of a
  /// sentence: "the process ended with status 1".
  robot::Result<std::string> ask(std::string_view line, double patience_seconds);

 private:
  Process(pid_t pid, robot::FileDescriptor socket) : pid_(pid), socket_(std::move(socket)) {}
  robot::Error how_it_ended();
  robot::Error more_than_one_line() const;

  pid_t pid_;
  robot::FileDescriptor socket_;
  std::string read_;  // behind the last answer
};

}  // namespace sim::guest
