// The options by which foresight-lab fit and plan-fit find their recordings.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "robot/app/clock_option.h"
#include "robot/fit/evidence.h"

namespace robot::app {

struct EvidenceOptions {
  std::vector<std::filesystem::path> sessions, truths;
  double max_clock_offset = 60;  // [s]

  /// Declares the options. `about` describes the sessions.
  void declare(CLI::App& command, const std::string& about) {
    command.add_option("sessions", sessions, about)->required();
    command.add_option("--truth", truths, "recordings of ground truth of the same games");
    add_clock_option(command, max_clock_offset);
  }

  /// Reads the recordings.
  Result<fit::Evidence> gather() const {
    const auto most_ns = clock_offset_ns(max_clock_offset);
    if (!most_ns) return most_ns.failure();
    return fit::gather(sessions, truths, *most_ns);
  }
};

}  // namespace robot::app
