// The options on the command line that say what is recorded where.
#pragma once

#include <cstdint>
#include <filesystem>
#include <string>

// forward declaration: each file that includes CLI11 compiles its constants, 2 s of processor time
namespace CLI {  // NOLINT(readability-identifier-naming): a library's name
class App;
}

namespace robot::app {

/// The values of these options.
struct RecordingSettings {
  bool record = false;  // from the start on
  std::string name;     // of the session that this begins
  std::filesystem::path log_folder = "logs";
  std::uint64_t log_mb = 50'000;  // of all sessions together

  std::uint64_t log_bytes() const { return log_mb * 1'000'000; }
};

/// Declares the options, which set `settings`.
void add_recording_options(CLI::App& command, RecordingSettings& settings);

}  // namespace robot::app
