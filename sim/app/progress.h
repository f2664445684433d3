// A progress bar on a terminal.
#pragma once

#include <cstdint>
#include <string>

namespace sim::app {

/// A progress bar on stderr, or nothing if stderr is no terminal. Used by one thread.
class ProgressBar {
 public:
  /// `what` is the activity, `all` the number of its steps.
  ProgressBar(std::string what, std::uint64_t all);
  /// Clears the bar.
  ~ProgressBar();
  ProgressBar(const ProgressBar&) = delete;
  ProgressBar& operator=(const ProgressBar&) = delete;

  void at(std::uint64_t done);

 private:
  const std::string what_;
  const std::uint64_t all_;
  const bool shown_;
  int percent_ = -1;
};

}  // namespace sim::app
