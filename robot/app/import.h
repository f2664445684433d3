// Recordings of others, made into sessions.
#pragma once

#include <filesystem>
#include <string>

#include "robot/app/robot_name.h"
#include "robot/core/result.h"
#include "robot/lab/import/import_sink.h"

namespace robot::app {

struct ImportRequest {
  std::string format;  // "bhuman2009", "nblog", or "auto": told by the file's own bytes
  std::filesystem::path file;
  std::filesystem::path session;  // the folder to be made
  RobotName robot;
  std::string name;
};

/// Writes the session. A damaged file gives what comes before the damage; the report names it.
/// An Error leaves no session behind.
Result<lab::ImportReport> import_recording(const ImportRequest& request);

/// Makes a session of `seconds` of a robot that never was.
Result<lab::ImportReport> synthesize(const std::filesystem::path& session, RobotName robot, double seconds);

/// When the recordings of the formats that tell no date are said to have been made [ns since the epoch]:
/// 2009-07-01, 0:00 UTC, the summer the B-Human recording is from.
inline constexpr std::uint64_t kUndatedEpochNs = 1'246'406'400ull * 1'000'000'000;

}  // namespace robot::app
