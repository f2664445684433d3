#include "robot/lab/import/truth_feeds.h"

#include <utility>

#include "robot/core/text.h"
#include "robot/truth/feeds/ssl_log.h"
#include "robot/truth/feeds/ssl_vision.h"
#include "robot/truth/feeds/truth_csv.h"

namespace robot::lab {
namespace {

constexpr std::size_t kFirstLines = 65'536;  // [bytes] enough for the header and a line

void warn_of(std::uint64_t count, const char* what, ImportReport& report) {
  if (count > 0) report.warnings.push_back(std::to_string(count) + what);
}

/// Reads the packets of a log. Keeps the first warning and the first fault.
class LogImport {
 public:
  LogImport(const truth::SslTeams& teams, ImportReport& report) : vision_(teams), report_(report) {}

  std::optional<truth::TimedTruth> take(const truth::SslLogMessage& message) {
    auto world = vision_.take(message.bytes, message.received_ns);
    if (!vision_.warning().empty() && warning_.empty()) warning_ = vision_.warning();
    if (world) return *std::move(world);
    if (fault_.empty()) fault_ = world.error();
    return std::nullopt;
  }

  void describe(const truth::SslTeams& teams) {
    if (const auto& field = vision_.field())
      report_.about = formatted("field of %.2f x %.2f m; ", field->length, field->width);
    report_.about += formatted("yellow is team %u, blue is team %u", teams.yellow, teams.blue);
    const truth::SslVisionCounts& counts = vision_.counts();
    warn_of(counts.unreadable, (" packets could not be read, such as: " + fault_).c_str(), report_);
    warn_of(counts.old, " packets came late or twice and were left out", report_);
    if (!warning_.empty()) report_.warnings.push_back(warning_);
  }

 private:
  truth::SslVision vision_;
  ImportReport& report_;
  std::string warning_, fault_;
};

}  // namespace

Result<ImportReport> import_truth_csv(std::string_view file_bytes, std::uint64_t epoch_ns, ImportSink& sink) {
  Result<truth::TruthCsv> csv = truth::read_truth_csv(file_bytes);
  if (!csv) return csv.failure();
  ImportReport report;
  report.damage = std::move(csv->damage);
  if (!csv->ignored.empty()) report.warnings.push_back("columns of other data: " + joined(csv->ignored, ", "));
  CountingSink counted(sink, report);
  for (const truth::TimedTruth& moment : csv->moments) {
    const std::uint64_t capture_ns = moment.capture_ns + (csv->dated ? 0 : epoch_ns);
    if (const Result<void> taken = counted.message(memory::kTruthTopic, capture_ns, moment.truth); !taken)
      return taken.failure();
  }
  return report;
}

Result<ImportReport> import_ssl_log(std::string_view file_bytes, const truth::SslTeams& teams, ImportSink& sink) {
  Result<truth::SslLogReader> log = truth::SslLogReader::open(file_bytes);
  if (!log) return log.failure();
  ImportReport report;
  CountingSink counted(sink, report);
  LogImport import(teams, report);
  while (true) {
    const Result<std::optional<truth::SslLogMessage>> message = log->next();
    if (!message) report.damage = message.error();
    if (!message || !*message) break;
    if (!(*message)->vision) continue;
    const std::optional<truth::TimedTruth> world = import.take(**message);
    if (!world) continue;
    if (const Result<void> taken = counted.message(memory::kTruthTopic, world->capture_ns, world->truth); !taken)
      return taken.failure();
  }
  import.describe(teams);
  return report;
}

std::optional<std::uint64_t> truth_csv_date(std::string_view file_bytes) {
  const Result<truth::TruthCsv> csv = truth::read_truth_csv(file_bytes.substr(0, kFirstLines));
  if (!csv || !csv->dated) return std::nullopt;
  return csv->moments.front().capture_ns;
}

std::optional<std::uint64_t> ssl_log_date(std::string_view file_bytes) {
  Result<truth::SslLogReader> log = truth::SslLogReader::open(file_bytes);
  if (!log) return std::nullopt;
  const Result<std::optional<truth::SslLogMessage>> first = log->next();
  if (!first || !*first) return std::nullopt;
  return (*first)->received_ns;
}

}  // namespace robot::lab
