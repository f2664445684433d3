// Recordings of other programs and of the synthetic robot as sessions.
#pragma once

#include <filesystem>
#include <string>

#include "robot/app/robot_name.h"
#include "robot/core/result.h"
#include "robot/lab/import/import_sink.h"
#include "robot/truth/feeds/ssl_packet.h"

namespace robot::app {

/// The arguments of an import.
struct ImportRequest {
  std::string format;  // kImportFormats, or "auto": recognised by the first bytes of the file
  std::filesystem::path file;
  std::filesystem::path session;  // folder that is created; empty: one in `out` with a name of time, name and profile
  std::filesystem::path out;
  RobotName robot;
  std::string name;
  truth::SslTeams teams;   // of ssl_log
  bool find_ball = false;  // bhuman2009: adds `vision` with the orange ball and a truth by odometry
};

/// The formats of other programs, as in sentences.
inline constexpr const char* kImportFormats = "bhuman2009, nblog, spl_labels, ssl_log, teamcomm, truth_csv";

/// The result of an import.
struct Imported {
  std::filesystem::path session;
  lab::ImportReport report;
};

/// Writes the session, with the rules of its game. If no file says them, the session's description says that they are
/// assumed. From a damaged file it imports everything before the damage, and the report names the damage.
/// After an Error there is no session.
Result<Imported> import_recording(const ImportRequest& request);

/// Writes a session of the synthetic robot, `seconds` long (1 .. 600).
Result<lab::ImportReport> synthesize(const std::filesystem::path& session, RobotName robot, double seconds);

/// Start time [ns since the epoch] of recordings whose format contains no date: 2009-07-01, 0:00 UTC, the summer of
/// B-Human's recording.
inline constexpr std::uint64_t kUndatedEpochNs = 1'246'406'400ull * 1'000'000'000;

}  // namespace robot::app
