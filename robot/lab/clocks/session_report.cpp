#include "robot/lab/clocks/session_report.h"

#include <algorithm>
#include <cstdio>
#include <ctime>

#include "robot/core/clock.h"
#include "robot/core/json_library.h"
#include "robot/logging/sessions/session_provider.h"

namespace robot::lab {
namespace {

template <class... Values>
std::string format(const char* pattern, Values... values) {
  char text[512];
  std::snprintf(text, sizeof text, pattern, values...);
  return text;
}

std::string utc(std::uint64_t time_ns) {
  const std::time_t seconds = static_cast<std::time_t>(time_ns / kSecond);
  std::tm calendar{};
  gmtime_r(&seconds, &calendar);
  char text[32];
  std::strftime(text, sizeof text, "%Y-%m-%d %H:%M:%S", &calendar);
  return text;
}

StreamReport inspect_stream(const logging::Session& session, const logging::StreamFile& file) {
  StreamReport report{.file = file.file,
                      .topic = file.topic,
                      .schema = file.schema,
                      .size_bytes = file.size_bytes,
                      .damage = file.damage};
  const auto stream = logging::provider_of(session, file);
  if (const auto info = stream->open(); !info) {
    report.damage = info.error();
    return report;
  }
  std::uint64_t last_sequence = 0, last_capture_ns = 0;
  while (true) {
    const Result<std::optional<logging::Record>> record = stream->read();
    if (!record) {
      if (report.damage.empty()) report.damage = record.error();
      continue;
    }
    if (!*record) break;
    const logging::Record& message = **record;
    if (report.messages == 0) report.start_ns = report.end_ns = message.capture_ns;
    if (report.messages > 0) {
      if (session.numbered && message.sequence > last_sequence + 1)
        report.missing += message.sequence - last_sequence - 1;
      if (message.capture_ns > last_capture_ns)
        report.longest_gap =
            std::max(report.longest_gap, static_cast<double>(message.capture_ns - last_capture_ns) * 1e-9);
    }
    report.start_ns = std::min(report.start_ns, message.capture_ns);
    report.end_ns = std::max(report.end_ns, message.capture_ns);
    last_sequence = message.sequence;
    last_capture_ns = message.capture_ns;
    ++report.messages;
  }
  if (report.end_ns > report.start_ns)
    report.rate_hz =
        static_cast<double>(report.messages - 1) / (static_cast<double>(report.end_ns - report.start_ns) * 1e-9);
  return report;
}

}  // namespace

Result<SessionReport> inspect(const std::filesystem::path& path) {
  Result<logging::Session> session = logging::open_session(path);
  if (!session) return session.failure();
  SessionReport report{.session = std::move(*session), .streams = {}, .clock = {}};
  report.clock = read_clock(report.session);
  for (const logging::StreamFile& file : report.session.streams)
    report.streams.push_back(inspect_stream(report.session, file));
  return report;
}

std::string to_text(const SessionReport& report) {
  const logging::Session& session = report.session;
  std::string text = format("session  %s (%s)\n", session.id().c_str(), std::string(name(session.state)).c_str());
  text += format("robot    %s, profile %s, build %s\n", session.info.robot.c_str(), session.info.profile.c_str(),
                 session.info.build.c_str());
  text += format("time     %s UTC, %.1f s\n", utc(session.start_ns).c_str(),
                 static_cast<double>(session.end_ns - session.start_ns) * 1e-9);
  text += format("size     %.1f MB\n", static_cast<double>(session.size_bytes) * 1e-6);
  for (const auto& [peer, offset] : report.clock.peers)
    text += "clock    " + peer + " is " + to_text(offset) + " of that of " + report.clock.who + "\n";
  if (!session.message.empty()) text += "note     " + session.message + "\n";
  text += format("\n%-30s %-24s %9s %9s %9s %9s %11s\n", "topic", "schema", "messages", "Hz", "missing", "kB",
                 "longest gap");
  for (const StreamReport& stream : report.streams) {
    const std::string& shown = stream.topic.empty() ? stream.file : stream.topic;
    text += format("%-30s %-24s %9llu %9.1f %9llu %9.1f %9.3f s\n", shown.c_str(), stream.schema.c_str(),
                   static_cast<unsigned long long>(stream.messages), stream.rate_hz,
                   static_cast<unsigned long long>(stream.missing), static_cast<double>(stream.size_bytes) * 1e-3,
                   stream.longest_gap);
    if (!stream.damage.empty()) text += "  damaged: " + stream.damage + "\n";
  }
  return text;
}

nlohmann::json to_json(const SessionReport& report) {
  const logging::Session& session = report.session;
  nlohmann::json streams = nlohmann::json::array();
  for (const StreamReport& stream : report.streams)
    streams.push_back({{"file", stream.file},
                       {"topic", stream.topic},
                       {"schema", stream.schema},
                       {"messages", stream.messages},
                       {"size_bytes", stream.size_bytes},
                       {"start_ns", std::to_string(stream.start_ns)},
                       {"end_ns", std::to_string(stream.end_ns)},
                       {"rate_hz", stream.rate_hz},
                       {"missing", stream.missing},
                       {"longest_gap_s", stream.longest_gap},
                       {"damage", stream.damage}});
  nlohmann::json peers = nlohmann::json::object();
  for (const auto& [peer, offset] : report.clock.peers)
    peers[peer] = {{"offset_ns", std::to_string(offset.offset_ns)}, {"error_ns", std::to_string(offset.error_ns)}};
  return {{"session", session.id()},
          {"state", name(session.state)},
          {"message", session.message},
          {"robot", session.info.robot},
          {"profile", session.info.profile},
          {"build", session.info.build},
          {"start_ns", std::to_string(session.start_ns)},
          {"end_ns", std::to_string(session.end_ns)},
          {"size_bytes", session.size_bytes},
          {"clock", {{"of", report.clock.who}, {"peers", std::move(peers)}}},
          {"streams", std::move(streams)}};
}

}  // namespace robot::lab
