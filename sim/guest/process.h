// A process that is asked a line and answers a line.
#pragma once

#include <sys/types.h>

#include <string>
#include <string_view>

#include "robot/core/files.h"
#include "robot/core/result.h"

namespace sim::guest {

/// Ends with this object: its input ends, and if it stays it is killed. Its errors go where ours go.
class Process {
 public:
  static constexpr std::size_t kLongestLine = 1 << 16;

  /// Starts a command of the shell.
  static robot::Result<Process> start(const std::string& command);

  Process(Process&& other) noexcept;
  Process& operator=(Process&&) = delete;
  ~Process();

  /// Its answer to `line`, without the line's end; what it said unasked is none. The Error is the end of a sentence:
  /// "the process ended with status 1".
  robot::Result<std::string> ask(std::string_view line, double patience_seconds);

 private:
  Process(pid_t pid, robot::FileDescriptor socket) : pid_(pid), socket_(std::move(socket)) {}
  robot::Error how_it_ended();
  robot::Error more_than_one_line() const;

  pid_t pid_;
  robot::FileDescriptor socket_;
  std::string read_;  // behind the line that was answered last
};

}  // namespace sim::guest
