#include "robot/app/import.h"

#include "robot/app/build_id.h"
#include "robot/core/files.h"
#include "robot/lab/import/bhuman2009.h"
#include "robot/lab/import/label_rows.h"
#include "robot/lab/import/nblog.h"
#include "robot/lab/import/resting_ball.h"
#include "robot/lab/import/session_sink.h"
#include "robot/lab/import/spl_labels.h"
#include "robot/lab/import/teamcomm.h"
#include "robot/lab/import/truth_feeds.h"
#include "robot/lab/synthetic/synthetic.h"
#include "robot/logging/sessions/session_name.h"
#include "robot/logging/sessions/session_writer.h"
#include "robot/truth/feeds/ssl_log.h"
#include "robot/truth/feeds/truth_csv.h"

namespace robot::app {
namespace {

/// Rules with the field of 9 x 6 m, on which the synthetic robot plays and onto which label files are fitted.
constexpr const char* kWideField = "spl2025";
constexpr std::size_t kMaxRecordingBytes = 2'000'000'000;

std::string format_of(std::string_view bytes) {
  // an nblog begins with 4 bytes for the size of its header; the header begins with its name
  if (bytes.size() > 10 && bytes.substr(4, 6) == "(nblog") return "nblog";
  if (truth::is_ssl_log(bytes)) return "ssl_log";
  if (lab::is_teamcomm_log(bytes)) return "teamcomm";
  if (lab::labels::is_label_file(bytes)) return "spl_labels";
  return truth::is_truth_csv(bytes) ? "truth_csv" : "bhuman2009";
}

/// Returns the time of the beginning of a recording [ns since the epoch].
std::uint64_t start_ns_of(const std::string& format, std::string_view bytes) {
  if (format == "ssl_log") return lab::ssl_log_date(bytes).value_or(kUndatedEpochNs);
  if (format == "truth_csv") return lab::truth_csv_date(bytes).value_or(kUndatedEpochNs);
  return kUndatedEpochNs;
}

Result<lab::ImportReport> import_bytes(const std::string& format, std::string_view bytes, const ImportRequest& request,
                                       lab::ImportSink& sink) {
  const auto bhuman2009 = [&](lab::ImportSink& to) { return lab::import_bhuman2009(bytes, kUndatedEpochNs, to); };
  if (request.find_ball && format != "bhuman2009")
    return Error{"--find-ball is for bhuman2009, got the format " + format};
  if (request.find_ball) return lab::import_with_ball(sink, bhuman2009);
  if (format == "bhuman2009") return bhuman2009(sink);
  if (format == "nblog") return lab::import_nblog(bytes, kUndatedEpochNs, sink);
  if (format == "spl_labels") return lab::import_spl_labels(bytes, kUndatedEpochNs, sink);
  if (format == "teamcomm") return lab::import_teamcomm(bytes, kUndatedEpochNs, sink);
  if (format == "ssl_log") return lab::import_ssl_log(bytes, request.teams, sink);
  if (format == "truth_csv") return lab::import_truth_csv(bytes, kUndatedEpochNs, sink);
  return Error{"import: expected the format auto or one of " + std::string(kImportFormats) + ", got '" + format + "'"};
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
  if (format == "teamcomm")
    return {"spl2025:5",
            "assumed: the rules spl2025:5, because packets of version 6 are of 2015 and 2016, five a side on 9 x 6 m"};
  if (format == "ssl_log" || format == "truth_csv") return {"", ""};
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

Result<Imported> import_recording(const ImportRequest& request) {
  const Result<std::string> bytes = read_file(request.file, kMaxRecordingBytes);
  if (!bytes) return bytes.failure("import");
  const std::string format = request.format == "auto" ? format_of(*bytes) : request.format;
  const PlayedBy played = rules_of(format);
  const std::uint64_t start_ns = start_ns_of(format, *bytes);
  const std::filesystem::path session =
      request.session.empty() ? request.out / logging::session_folder_name(start_ns, request.name, "import")
                              : request.session;
  auto report = write_import(session, session_info(request.robot, request.name, played.rules, start_ns),
                             [&](lab::ImportSink& sink) -> Result<lab::ImportReport> {
                               Result<lab::ImportReport> filled = import_bytes(format, *bytes, request, sink);
                               if (filled && filled->messages.empty())
                                 return Error{"import: " + request.file.string() + " contains no message" +
                                              (filled->damage.empty() ? "" : ": " + filled->damage)};
                               if (!filled) return filled.failure("import: " + request.file.string());
                               if (!played.assumed.empty())
                                 filled->about += (filled->about.empty() ? "" : "; ") + played.assumed;
                               return filled;
                             });
  if (!report) return report.failure();
  return Imported{.session = session, .report = *std::move(report)};
}

Result<lab::ImportReport> synthesize(const std::filesystem::path& session, RobotName robot, double seconds) {
  if (!(seconds >= 1 && seconds <= 600))
    return Error{"synthesize: seconds must be 1 .. 600, got " + std::to_string(seconds)};
  const lab::SyntheticRobot::Options options{.seconds = seconds};
  return write_import(session, session_info(robot, "synthetic", kWideField, options.epoch_ns),
                      [&](lab::ImportSink& sink) { return lab::SyntheticRobot(options).write(sink); });
}

}  // namespace robot::app
