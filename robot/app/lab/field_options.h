// The options about the field that sensors watch.
#pragma once

#include <CLI/CLI.hpp>

#include "robot/app/truth/watch_truth.h"

namespace robot::app {

/// Adds --rules and --ball-radius, whose values go to `truth`.
inline void add_field_options(CLI::App& command, TruthOptions& truth) {
  command.add_option("--rules", truth.rules, "rules, which give the field: spl2012, spl2025:5, …")
      ->capture_default_str();
  command.add_option("--ball-radius", truth.ball_radius, "[m] default: that of the rules")
      ->check(CLI::Range(0.02, 0.15));
}

}  // namespace robot::app
