#include "robot/app/recording_settings.h"

#include <CLI/CLI.hpp>

namespace robot::app {

void add_recording_options(CLI::App& command, RecordingSettings& settings) {
  command.add_flag("--record", settings.record, "record from the start");
  command.add_option("--name", settings.name, "name of the session that --record begins");
  command.add_option("--log-dir", settings.log_folder, "folder of recorded sessions")->capture_default_str();
  command.add_option("--log-mb", settings.log_mb, "[MB] limit of all sessions together; the oldest are deleted first")
      ->capture_default_str();
}

}  // namespace robot::app
