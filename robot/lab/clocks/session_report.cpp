#include "robot/lab/clocks/session_report.h"

#include <algorithm>
#include <cstdio>
#include <cstdlib>
#include <ctime>
#include <map>
#include <set>

#include "robot/core/clock.h"
#include "robot/core/json_library.h"
#include "robot/core/text.h"
#include "robot/logging/mcap/ordered_reader.h"
#include "robot/logging/mcap/topic_streams.h"
#include "robot/logging/sessions/session_provider.h"

namespace robot::lab {
namespace {

std::string utc(std::uint64_t time_ns) {
  const std::time_t seconds = static_cast<std::time_t>(time_ns / kSecond);
  std::tm calendar{};
  gmtime_r(&seconds, &calendar);
  char text[32];
  std::strftime(text, sizeof text, "%Y-%m-%d %H:%M:%S", &calendar);
  return text;
}

StreamReport described(const logging::StreamFile& file) {
  return {.file = file.file,
          .topic = file.topic,
          .schema = file.schema,
          .size_bytes = file.size_bytes,
          .damage = file.damage,
          .note = file.note};
}

/// The report of a stream while its messages are read.
class Inspection {
 public:
  explicit Inspection(const logging::StreamFile& file) : report_(described(file)) {}

  void take(const logging::Record& message) {
    if (report_.messages++ == 0) {
      report_.start_ns = report_.end_ns = message.capture_ns;
      first_sequence_ = last_sequence_ = message.sequence;
    } else if (message.capture_ns > last_capture_ns_) {
      report_.longest_gap =
          std::max(report_.longest_gap, static_cast<double>(message.capture_ns - last_capture_ns_) * 1e-9);
    }
    report_.start_ns = std::min(report_.start_ns, message.capture_ns);
    report_.end_ns = std::max(report_.end_ns, message.capture_ns);
    first_sequence_ = std::min(first_sequence_, message.sequence);
    last_sequence_ = std::max(last_sequence_, message.sequence);
    last_capture_ns_ = message.capture_ns;
  }

  void note_damage(const std::string& sentence) {
    if (report_.damage.empty()) report_.damage = sentence;
  }

  /// Returns the report. `numbered`: the messages have the numbers 1, 2, 3 …
  StreamReport finished(bool numbered) && {
    // in the order of their times messages need not be in the order of their numbers
    const std::uint64_t numbers = last_sequence_ - first_sequence_ + 1;
    if (numbered && report_.messages > 0 && numbers > report_.messages) report_.missing = numbers - report_.messages;
    if (report_.end_ns > report_.start_ns)
      report_.rate_hz =
          static_cast<double>(report_.messages - 1) / (static_cast<double>(report_.end_ns - report_.start_ns) * 1e-9);
    return std::move(report_);
  }

 private:
  StreamReport report_;
  std::uint64_t first_sequence_ = 0, last_sequence_ = 0, last_capture_ns_ = 0;
};

StreamReport inspect_stream(const logging::Session& session, const logging::StreamFile& file) {
  Inspection inspection(file);
  const auto stream = logging::provider_of(session, file);
  if (const auto info = stream->open(); !info) {
    StreamReport report = described(file);
    report.damage = info.error();
    return report;
  }
  while (true) {
    const Result<std::optional<logging::Record>> record = stream->read();
    if (!record) {
      inspection.note_damage(record.error());
      continue;
    }
    if (!*record) return std::move(inspection).finished(session.numbered);
    inspection.take(**record);
  }
}

/// Reads a file with many channels once, for all its streams.
void inspect_file(SessionReport& report) {
  const logging::Session& session = report.session;
  std::vector<Inspection> inspections;
  std::map<std::string, std::size_t> places;
  for (const logging::StreamFile& file : session.streams) {
    places.emplace(file.topic, inspections.size());
    inspections.emplace_back(file);
  }
  std::map<std::uint16_t, std::size_t> of_channel;
  std::set<std::uint16_t> wanted;
  for (const logging::TopicStream& stream : logging::topic_streams(session.one_file->index()))
    for (const std::uint16_t channel : stream.channels) {
      of_channel[channel] = places.at(stream.info.topic);
      wanted.insert(channel);
    }
  logging::OrderedReader reader(session.one_file, std::move(wanted));
  while (true) {
    const auto message = reader.next();
    if (message && !*message) break;
    if (!message)
      report.damages.push_back(message.error());
    else
      inspections[of_channel.at((*message)->channel_id)].take((*message)->record);
  }
  for (Inspection& inspection : inspections) report.streams.push_back(std::move(inspection).finished(session.numbered));
}

}  // namespace

Result<SessionReport> inspect(const std::filesystem::path& path) {
  Result<logging::Session> session = logging::open_session(path);
  if (!session) return session.failure();
  SessionReport report{.session = std::move(*session), .streams = {}, .damages = {}, .clock = {}};
  report.clock = read_clock(report.session);
  if (report.session.one_file)
    inspect_file(report);
  else
    for (const logging::StreamFile& file : report.session.streams)
      report.streams.push_back(inspect_stream(report.session, file));
  return report;
}

std::string to_text(const SessionReport& report) {
  const logging::Session& session = report.session;
  std::string text = formatted("session  %s (%s)\n", session.id().c_str(), std::string(name(session.state)).c_str());
  text += formatted("robot    %s, profile %s, build %s\n", session.info.robot.c_str(), session.info.profile.c_str(),
                    session.info.build.c_str());
  if (!session.info.only.empty())
    text += "objects  " + joined(session.info.only, ", ") + "; the others were left out by choice\n";
  if (!session.info.about.empty()) text += "about    " + session.info.about + "\n";
  text += formatted("time     %s UTC, %.1f s\n",
                    utc(session.start_ns + static_cast<std::uint64_t>(session.info.behind_ns)).c_str(),
                    static_cast<double>(session.end_ns - session.start_ns) * 1e-9);
  text += formatted("size     %.1f MB\n", static_cast<double>(session.size_bytes) * 1e-6);
  if (session.info.behind_ns != 0)
    text += formatted("clock    it was set while the program ran: the recorded times are %.1f s %s the time of day\n",
                      static_cast<double>(std::abs(session.info.behind_ns)) * 1e-9,
                      session.info.behind_ns > 0 ? "behind" : "ahead of");
  for (const auto& [peer, offset] : report.clock.peers)
    text += "clock    " + peer + " is " + to_text(offset) + " of that of " + report.clock.who + "\n";
  if (!session.message.empty()) text += "note     " + session.message + "\n";
  for (const std::string& damage : report.damages)
    if (session.message.find(damage) == std::string::npos) text += "note     " + damage + "\n";
  text += formatted("\n%-30s %-24s %9s %9s %9s %9s %11s\n", "topic", "schema", "messages", "Hz", "missing", "kB",
                    "longest gap");
  for (const StreamReport& stream : report.streams) {
    const std::string& shown = stream.topic.empty() ? stream.file : stream.topic;
    text += formatted("%-30s %-24s %9llu %9.1f %9llu %9.1f %9.3f s\n", shown.c_str(), stream.schema.c_str(),
                      static_cast<unsigned long long>(stream.messages), stream.rate_hz,
                      static_cast<unsigned long long>(stream.missing), static_cast<double>(stream.size_bytes) * 1e-3,
                      stream.longest_gap);
    if (!stream.damage.empty()) text += "  damaged: " + stream.damage + "\n";
    if (!stream.note.empty()) text += "  note: " + stream.note + "\n";
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
                       {"damage", stream.damage},
                       {"note", stream.note}});
  nlohmann::json peers = nlohmann::json::object();
  for (const auto& [peer, offset] : report.clock.peers)
    peers[peer] = {{"offset_ns", std::to_string(offset.offset_ns)}, {"error_ns", std::to_string(offset.error_ns)}};
  return {{"session", session.id()},
          {"state", name(session.state)},
          {"message", session.message},
          {"about", session.info.about},
          {"robot", session.info.robot},
          {"profile", session.info.profile},
          {"only", session.info.only},
          {"behind_ns", std::to_string(session.info.behind_ns)},
          {"build", session.info.build},
          {"start_ns", std::to_string(session.start_ns)},
          {"end_ns", std::to_string(session.end_ns)},
          {"size_bytes", session.size_bytes},
          {"clock", {{"of", report.clock.who}, {"peers", std::move(peers)}}},
          {"damages", report.damages},
          {"streams", std::move(streams)}};
}

}  // namespace robot::lab
