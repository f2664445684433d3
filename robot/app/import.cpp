#include "robot/app/import.h"

#include "robot/app/build_id.h"
#include "robot/core/files.h"
#include "robot/lab/import/bhuman2009.h"
#include "robot/lab/import/label_rows.h"
#include "robot/lab/import/nblog.h"
#include "robot/lab/import/session_sink.h"
#include "robot/lab/import/spl_labels.h"
#include "robot/lab/synthetic/synthetic.h"
#include "robot/logging/sessions/session_writer.h"

namespace robot::app {
namespace {

/// Rules with the field of 9 x 6 m, on which the synthetic robot plays and onto which label files are fitted.
constexpr const char* kWideField = "spl2025";
constexpr std::size_t kMaxRecordingBytes = 2'000'000'000;

std::string format_of(std::string_view bytes) {
  // an nblog begins with 4 bytes for the size of its header; the header begins with its name
  if (bytes.size() > 10 && bytes.substr(4, 6) == "(nblog") return "nblog";
  return lab::labels::is_label_file(bytes) ? "spl_labels" : "bhuman2009";
}

Result<lab::ImportReport> import_bytes(const std::string& format, std::string_view bytes, lab::ImportSink& sink) {
  if (format == "bhuman2009") return lab::import_bhuman2009(bytes, kUndatedEpochNs, sink);
  if (format == "nblog") return lab::import_nblog(bytes, kUndatedEpochNs, sink);
  if (format == "spl_labels") return lab::import_spl_labels(bytes, kUndatedEpochNs, sink);
  return Error{"import: expected the format bhuman2009, nblog, spl_labels or auto, got '" + format + "'"};
}

/// The rules by which a recording was played, as far as its format shows them.
struct PlayedBy {
  std::string rules;
  std::string assumed;  // a sentence if no file says it, or empty
};

PlayedBy rules_of(const std::string& format) {
  // the league's field was 6 x 4 m until 2012, and a side had three robots until 2010
  if (format == "bhuman2009")
    return {"spl2012:3", "assumed: the rules spl2012:3, because the league of 2009 played three a side on 6 x 4 m"};
  if (format == "nblog")
    return {"spl2025:5", "assumed: the rules spl2025:5, because the league of 2014 played five a side on 9 x 6 m"};
  return {kWideField, ""};
}

logging::SessionInfo session_info(RobotName robot, std::string name, std::string rules, std::uint64_t start_ns) {
  return {.name = std::move(name),
          .robot = robot.text(),
          .team = robot.team,
          .player = robot.player,
          .build = std::string(kBuildId),
          .profile = "import",
          .rules = std::move(rules),
          .start_ns = start_ns};
}

/// Writes a session that `fill` fills through a sink, and describes it by the report.
template <class Fill>
Result<lab::ImportReport> write_import(const std::filesystem::path& folder, const logging::SessionInfo& info,
                                       Fill&& fill) {
  lab::ImportReport report;
  const Result<void> written =
      logging::write_session(folder, info, [&](logging::SessionWriter& writer) -> Result<void> {
        lab::SessionSink sink(info.robot, writer);
        auto filled = fill(sink);
        if (!filled) return filled.failure();
        writer.describe(filled->about);
        report = *std::move(filled);
        return {};
      });
  if (!written) return written.failure();
  return report;
}

}  // namespace

Result<lab::ImportReport> import_recording(const ImportRequest& request) {
  const Result<std::string> bytes = read_file(request.file, kMaxRecordingBytes);
  if (!bytes) return bytes.failure("import");
  const std::string format = request.format == "auto" ? format_of(*bytes) : request.format;
  const PlayedBy played = rules_of(format);
  return write_import(request.session, session_info(request.robot, request.name, played.rules, kUndatedEpochNs),
                      [&](lab::ImportSink& sink) -> Result<lab::ImportReport> {
                        Result<lab::ImportReport> report = import_bytes(format, *bytes, sink);
                        if (report && report->messages.empty())
                          return Error{"import: " + request.file.string() + " contains no message" +
                                       (report->damage.empty() ? "" : ": " + report->damage)};
                        if (!report) return report.failure("import: " + request.file.string());
                        if (!played.assumed.empty())
                          report->about += (report->about.empty() ? "" : "; ") + played.assumed;
                        return report;
                      });
}

Result<lab::ImportReport> synthesize(const std::filesystem::path& session, RobotName robot, double seconds) {
  if (!(seconds >= 1 && seconds <= 600))
    return Error{"synthesize: seconds must be 1 .. 600, got " + std::to_string(seconds)};
  const lab::SyntheticRobot::Options options{.seconds = seconds};
  return write_import(session, session_info(robot, "synthetic", kWideField, options.epoch_ns),
                      [&](lab::ImportSink& sink) { return lab::SyntheticRobot(options).write(sink); });
}

}  // namespace robot::app
