// The report of a session's contents, for a person or a program.
#pragma once

#include <cstdint>
#include <nlohmann/json_fwd.hpp>
#include <string>
#include <vector>

#include "robot/core/result.h"
#include "robot/lab/clocks/clock_agreement.h"
#include "robot/logging/sessions/session.h"

namespace robot::lab {

/// The statistics of one stream, from its first message to its last.
struct StreamReport {
  std::string file, topic, schema;  // topic and schema are empty if the file does not contain them
  std::uint64_t messages = 0, size_bytes = 0;
  std::uint64_t start_ns = 0, end_ns = 0;  // [ns since the epoch] capture times
  double rate_hz = 0;                      // mean; 0 with fewer than two messages
  std::uint64_t missing = 0;               // skipped sequence numbers: messages dropped while recording
  double longest_gap = 0;                  // [s] between two capture times
  std::string damage;                      // one sentence, or empty
  std::string note;                        // one sentence about messages that are left out, or empty
};

/// The report of a whole session.
struct SessionReport {
  logging::Session session;
  std::vector<StreamReport> streams;
  std::vector<std::string> damages;  // of a file with many channels, as found while reading: one sentence each
  RecordedClock clock;
};

/// Reads every message of a session's folder or of an MCAP file with many channels. The file is read once.
Result<SessionReport> inspect(const std::filesystem::path& path);

/// Formats the report as a table for a terminal, or as JSON.
std::string to_text(const SessionReport& report);
nlohmann::json to_json(const SessionReport& report);

}  // namespace robot::lab
