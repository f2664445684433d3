#include "robot/logging/sessions/session.h"

#include <algorithm>
#include <cctype>
#include <cstdlib>
#include <ctime>
#include <initializer_list>
#include <limits>

#include "robot/core/byte_source.h"
#include "robot/core/clock.h"
#include "robot/core/files.h"
#include "robot/core/json.h"
#include "robot/core/json_library.h"
#include "robot/logging/mcap/format.h"
#include "robot/logging/mcap/index.h"
#include "robot/logging/mcap/time_span.h"
#include "robot/logging/mcap/topic_streams.h"

namespace robot::logging {
namespace {

constexpr std::size_t kMaxSessionJsonBytes = 1 << 20;
constexpr const char* kSessionMetadata = "foresight.session";
constexpr std::size_t kPieceBytes = 1 << 18;
using Type = nlohmann::json::value_t;

/// Replaces everything but letters, digits and a few signs by '_'.
std::string tame(std::string_view text) {
  std::string tame(text);
  for (char& c : tame)
    if (!std::isalnum(static_cast<unsigned char>(c)) && c != '-' && c != '_' && c != '.') c = '_';
  return tame;
}

StreamFile read_stream(const std::filesystem::path& path) {
  StreamFile stream{.file = path.filename().string()};
  std::error_code ignored;
  stream.size_bytes = std::filesystem::file_size(path, ignored);
  const Result<std::shared_ptr<const FileSource>> source = FileSource::open(path);
  if (!source) {
    stream.damage = source.error();
    return stream;
  }
  const Result<McapIndex> index = read_index(**source);
  if (!index) {
    stream.damage = index.error();
    return stream;
  }
  stream.damage = index->damage;
  if (!index->channels.empty()) {
    const memory::ChannelInfo channel = channel_info(index->channels.begin()->second, index->schemas);
    stream.topic = channel.topic;
    stream.schema = channel.schema.name;
  }
  stream.messages = index->statistics.messages;
  stream.start_ns = index->statistics.start_ns;
  stream.end_ns = index->statistics.end_ns;
  return stream;
}

/// Returns the robot of a topic, "14/2" for "/14/2/ball", or an empty string for a topic without a robot.
std::string robot_of(const std::string& topic) {
  if (topic.size() < 2 || !std::isdigit(static_cast<unsigned char>(topic[1]))) return {};
  const std::size_t player = topic.find('/', 1);
  const std::size_t end = player == topic.npos ? topic.npos : topic.find('/', player + 1);
  return end == topic.npos ? std::string() : topic.substr(1, end - 1);
}

/// Joins the sentences that are not empty.
std::string joined(std::initializer_list<std::string_view> sentences) {
  std::string text;
  for (const std::string_view sentence : sentences) {
    if (!text.empty() && !sentence.empty()) text += "; ";
    text += sentence;
  }
  return text;
}

/// Returns the facts in the file's metadata, or without them, facts derived from its name and topics.
SessionInfo info_of(const McapIndex& index, const std::filesystem::path& file) {
  SessionInfo info{.name = file.stem().string(), .robot = "", .profile = "import", .complete = index.complete};
  for (const mcap::Metadata& metadata : index.metadata)
    if (metadata.name == kSessionMetadata)
      for (const auto& [key, value] : metadata.entries) {
        if (key == "name" && !value.empty()) info.name = value;
        if (key == "robot") info.robot = value;
        if (key == "build") info.build = value;
        if (key == "profile") info.profile = value;
      }
  for (const auto& [id, channel] : index.channels)
    if (info.robot.empty()) info.robot = robot_of(channel.topic);
  if (info.robot.empty()) info.robot = "0/1";
  info.team = std::atoi(info.robot.c_str());
  info.player = std::atoi(info.robot.c_str() + std::min(info.robot.find('/') + 1, info.robot.size()));
  return info;
}

}  // namespace

std::string to_json(const SessionInfo& info) {
  return nlohmann::json{{"name", info.name},
                        {"robot", info.robot},
                        {"team", info.team},
                        {"player", info.player},
                        {"build", info.build},
                        {"profile", info.profile},
                        {"start_ns", std::to_string(info.start_ns)},
                        {"kept", info.kept},
                        {"complete", info.complete}}
             .dump(2, ' ', false, nlohmann::json::error_handler_t::replace) +
         "\n";
}

MetadataByName metadata_of(const SessionInfo& info) {
  return {{kSessionMetadata,
           {{"name", info.name},
            {"robot", info.robot},
            {"team", std::to_string(info.team)},
            {"player", std::to_string(info.player)},
            {"build", info.build},
            {"profile", info.profile},
            {"start_ns", std::to_string(info.start_ns)}}}};
}

Result<SessionInfo> parse_session_info(std::string_view text) {
  const Result<nlohmann::json> parsed = parse_json(text);
  if (!parsed) return parsed.failure("session.json");
  const nlohmann::json& json = *parsed;
  if (!json.is_object()) return Error{"session.json: expected a JSON object"};
  SessionInfo info;
  std::string start, wrong;
  const auto take = [&](const char* key, auto& value, Type type) {
    const auto found = json.find(key);
    if (found != json.end() && (found->type() == type || (found->is_number_integer() && type == Type::number_integer)))
      found->get_to(value);
    else if (wrong.empty())
      wrong = key;
  };
  take("name", info.name, Type::string);
  take("robot", info.robot, Type::string);
  take("team", info.team, Type::number_integer);
  take("player", info.player, Type::number_integer);
  take("build", info.build, Type::string);
  take("profile", info.profile, Type::string);
  take("start_ns", start, Type::string);
  take("kept", info.kept, Type::boolean);
  take("complete", info.complete, Type::boolean);
  if (!wrong.empty()) return Error{"session.json: '" + wrong + "' is missing or of the wrong type"};
  info.start_ns = std::strtoull(start.c_str(), nullptr, 10);
  return info;
}

std::string_view name(SessionState state) {
  switch (state) {
    case SessionState::recording: return "recording";
    case SessionState::complete: return "complete";
    case SessionState::recovered: return "recovered";
    case SessionState::damaged: return "damaged";
  }
  return "?";
}

std::string stream_file_name(std::string_view topic) {
  if (topic.starts_with('/')) topic.remove_prefix(1);
  std::string file(topic);
  std::ranges::replace(file, '/', '.');
  return tame(file) + ".mcap";
}

Result<std::vector<SessionFile>> read_session_files(const std::filesystem::path& folder) {
  std::vector<SessionFile> files;
  std::string piece;
  std::error_code failed;
  for (const auto& entry : std::filesystem::directory_iterator(folder, failed)) {
    const auto source = FileSource::open(entry.path());
    if (!source) return source.failure();
    SessionFile file{.name = entry.path().filename().string(), .size_bytes = (*source)->size()};
    for (std::uint64_t at = 0; at < file.size_bytes; at += kPieceBytes) {
      piece.resize(static_cast<std::size_t>(std::min<std::uint64_t>(kPieceBytes, file.size_bytes - at)));
      if (const Result<void> read = (*source)->read(at, piece); !read) return read.failure();
      file.crc32 = mcap::crc32(piece, file.crc32);
    }
    files.push_back(std::move(file));
  }
  if (failed) return Error{"session " + folder.string() + ": " + failed.message()};
  std::ranges::sort(files, {}, &SessionFile::name);
  return files;
}

std::string session_folder_name(std::uint64_t start_ns, std::string_view name, std::string_view profile) {
  const std::time_t seconds = static_cast<std::time_t>(start_ns / kSecond);
  std::tm utc{};
  gmtime_r(&seconds, &utc);
  char text[32];
  std::strftime(text, sizeof text, "%Y-%m-%d_%H-%M-%S", &utc);
  return std::string(text) + "_" + tame(name.empty() ? profile : name);
}

Result<Session> read_session(const std::filesystem::path& folder, bool being_written) {
  const Result<std::string> text = read_file(folder / "session.json", kMaxSessionJsonBytes);
  if (!text) return text.failure("session " + folder.string());
  Result<SessionInfo> info = parse_session_info(*text);
  if (!info) return info.failure("session " + folder.string());

  Session session{.folder = folder, .info = std::move(*info)};
  std::error_code failed;
  for (const auto& entry : std::filesystem::directory_iterator(folder, failed))
    if (entry.path().extension() == ".mcap") session.streams.push_back(read_stream(entry.path()));
  std::ranges::sort(session.streams, {}, &StreamFile::file);

  session.state = being_written           ? SessionState::recording
                  : session.info.complete ? SessionState::complete
                                          : SessionState::recovered;
  session.start_ns = std::numeric_limits<std::uint64_t>::max();
  for (const StreamFile& stream : session.streams) {
    session.size_bytes += stream.size_bytes;
    if (!stream.damage.empty() && session.state == SessionState::complete) {
      session.state = SessionState::damaged;
      session.message = stream.damage;
    }
    if (stream.messages == 0) continue;
    session.start_ns = std::min(session.start_ns, stream.start_ns);
    session.end_ns = std::max(session.end_ns, stream.end_ns);
  }
  if (session.end_ns == 0) session.start_ns = session.end_ns = session.info.start_ns;
  if (session.state == SessionState::recovered)
    session.message = "the recording ended without warning; what was on the disk by then is readable";
  return session;
}

Result<Session> read_recording(const std::filesystem::path& path) {
  const auto file = McapFile::open(path);
  if (!file) return file.failure();
  const McapIndex& index = (*file)->index();

  Session session{.folder = path.parent_path(), .info = info_of(index, path)};
  session.one_file = *file;
  session.numbered = std::ranges::find(index.metadata, kSessionMetadata, &mcap::Metadata::name) != index.metadata.end();
  session.state = index.damage.empty() ? SessionState::complete : SessionState::damaged;
  session.size_bytes = index.size_bytes;
  const TimeSpan span = time_span((*file)->source(), index);
  session.start_ns = session.info.start_ns = span.start_ns;
  session.end_ns = span.end_ns;
  session.message = joined({index.damage, span.note()});
  for (TopicStream& stream : topic_streams(index))
    session.streams.push_back({.topic = stream.info.topic,
                               .file = path.filename().string(),
                               .schema = stream.info.schema.name,
                               .messages = stream.messages,
                               .start_ns = session.start_ns,
                               .end_ns = session.end_ns,
                               .left_out = stream.left_out,
                               .note = std::move(stream.note)});
  return session;
}

Result<Session> open_session(const std::filesystem::path& path) {
  std::error_code ignored;
  return std::filesystem::is_regular_file(path, ignored) ? read_recording(path) : read_session(path);
}

}  // namespace robot::logging
