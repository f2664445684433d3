// What a session holds, told to a person or a program.
#pragma once

#include <cstdint>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "robot/core/result.h"
#include "robot/lab/clocks/clock_agreement.h"
#include "robot/logging/sessions/session.h"

namespace robot::lab {

/// One stream, read from the first message to the last.
struct StreamReport {
  std::string file, topic, schema;  // the latter two are empty where the file does not tell them
  std::uint64_t messages = 0, size_bytes = 0;
  std::uint64_t start_ns = 0, end_ns = 0;  // [ns since the epoch] capture times
  double rate_hz = 0;                      // mean; 0 with fewer than two messages
  std::uint64_t missing = 0;               // sequence numbers that were skipped: messages dropped while recording
  double longest_gap = 0;                  // [s] between two capture times
  std::string damage;                      // one sentence, or empty
};

struct SessionReport {
  logging::Session session;
  std::vector<StreamReport> streams;
  RecordedClock clock;
};

/// Reads every message of the session in a folder, or of a recording of many channels in one file.
Result<SessionReport> inspect(const std::filesystem::path& path);

/// As a table for a terminal, and as JSON.
std::string to_text(const SessionReport& report);
nlohmann::json to_json(const SessionReport& report);

}  // namespace robot::lab
