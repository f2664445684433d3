// Ground truth that another program recorded: a CSV file of positions, or a log of the Small Size League.
#pragma once

#include <cstdint>
#include <optional>
#include <string_view>

#include "robot/core/result.h"
#include "robot/lab/import/import_sink.h"
#include "robot/truth/feeds/ssl_packet.h"

namespace robot::lab {

/// Passes /truth/world to `sink`, one message for each moment of a CSV file (robot/truth/feeds/truth_csv.h describes it).
/// `epoch_ns` [ns since the epoch] is the start of a file whose times do not count from the epoch.
/// From a file with a wrong line it imports everything before, and the report names line and column. Returns an Error for a
/// wrong header, or if the sink returns one.
Result<ImportReport> import_truth_csv(std::string_view file_bytes, std::uint64_t epoch_ns, ImportSink& sink);

/// Passes /truth/world to `sink`, one message for each world that SSL-Vision saw (robot/truth/feeds/ssl_log.h and
/// ssl_vision.h describe file and packets). The report counts packets that were of no use.
/// From a damaged log it imports everything before the damage. Returns an Error for another file, or if the sink returns one.
Result<ImportReport> import_ssl_log(std::string_view file_bytes, const truth::SslTeams& teams, ImportSink& sink);

/// Returns the time of the first entry of such a file [ns since the epoch], or nothing if it has none with a date.
std::optional<std::uint64_t> truth_csv_date(std::string_view file_bytes);
std::optional<std::uint64_t> ssl_log_date(std::string_view file_bytes);

}  // namespace robot::lab
