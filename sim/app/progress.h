// How far something is, on a terminal.
#pragma once

#include <cstdint>
#include <string>

namespace sim::app {

/// A bar on stderr where that is a terminal, else nothing. Used by one thread.
class Progress {
 public:
  /// `what` is being done, `all` times.
  Progress(std::string what, std::uint64_t all);
  /// Takes the bar away.
  ~Progress();
  Progress(const Progress&) = delete;
  Progress& operator=(const Progress&) = delete;

  void at(std::uint64_t done);

 private:
  const std::string what_;
  const std::uint64_t all_;
  const bool shown_;
  int percent_ = -1;
};

}  // namespace sim::app
