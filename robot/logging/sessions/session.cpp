#include "robot/logging/sessions/session.h"

#include <algorithm>
#include <cctype>
#include <cstdlib>
#include <initializer_list>
#include <optional>
#include <utility>

#include "robot/core/byte_source.h"
#include "robot/core/files.h"
#include "robot/core/folder.h"
#include "robot/logging/mcap/format.h"
#include "robot/logging/mcap/index.h"
#include "robot/logging/mcap/time_span.h"
#include "robot/logging/mcap/topic_streams.h"
#include "robot/logging/sessions/retained.h"

namespace robot::logging {
namespace {

namespace fs = std::filesystem;

/// The file of a stream, and the facts about the session in it.
struct ReadFile {
  StreamFile stream;
  std::vector<TimeGroup> times;
  std::optional<SessionInfo> facts;
  bool complete = false;  // its writer closed it
};

ReadFile read_stream(const fs::path& path, std::uint64_t size_bytes) {
  ReadFile read{.stream = {.file = path.filename().string(), .size_bytes = size_bytes}};
  StreamFile& stream = read.stream;
  const Result<std::shared_ptr<const FileSource>> source = FileSource::open(path);
  if (!source) {
    stream.damage = source.error();
    return read;
  }
  const Result<McapIndex> index = read_index(**source);
  if (!index) {
    stream.damage = index.error();
    return read;
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
  read.times = time_groups(**source, *index);
  read.facts = session_info_in(index->metadata);
  read.complete = index->complete;
  return read;
}

/// Returns the robot of a topic, "14/2" for "/14/2/ball", or an empty string for a topic without a robot.
std::string robot_of(const std::string& topic) {
  if (topic.size() < 2 || !std::isdigit(static_cast<unsigned char>(topic[1]))) return {};
  const std::size_t player = topic.find('/', 1);
  const std::size_t end = player == topic.npos ? topic.npos : topic.find('/', player + 1);
  return end == topic.npos ? std::string() : topic.substr(1, end - 1);
}

/// Joins the sentences that are not empty.
std::string sentences_of(std::initializer_list<std::string_view> sentences) {
  std::string text;
  for (const std::string_view sentence : sentences) {
    if (!text.empty() && !sentence.empty()) text += "; ";
    text += sentence;
  }
  return text;
}

/// Sets the numbers of team and player from the robot's name.
void take_numbers(SessionInfo& info) {
  if (info.robot.empty()) info.robot = "0/1";
  info.team = std::atoi(info.robot.c_str());
  info.player = std::atoi(info.robot.c_str() + std::min(info.robot.find('/') + 1, info.robot.size()));
}

/// Returns the facts in the file's metadata, or without them, facts derived from its name and topics.
SessionInfo info_of(const McapIndex& index, const fs::path& file) {
  SessionInfo info{.name = file.stem().string(), .robot = "", .profile = "import", .complete = index.complete};
  if (const std::optional<SessionInfo> facts = session_info_in(index.metadata)) {
    if (!facts->name.empty()) info.name = facts->name;
    info.robot = facts->robot;
    info.build = facts->build;
    info.profile = facts->profile;
    info.rules = facts->rules;
    info.only = facts->only;
    info.behind_ns = facts->behind_ns;
  }
  for (const auto& [id, channel] : index.channels)
    if (info.robot.empty()) info.robot = robot_of(channel.topic);
  take_numbers(info);
  return info;
}

/// Returns the facts in the first file that has some, or without them, facts derived from the topics.
SessionInfo info_of(const std::vector<ReadFile>& files) {
  SessionInfo info{.robot = "", .profile = "import"};
  const auto known = std::ranges::find_if(files, [](const ReadFile& file) { return file.facts.has_value(); });
  if (known != files.end()) info = *known->facts;
  for (const ReadFile& file : files)
    if (info.robot.empty()) info.robot = robot_of(file.stream.topic);
  if (known == files.end()) take_numbers(info);
  info.complete = !files.empty() && std::ranges::all_of(files, &ReadFile::complete);
  return info;
}

/// Returns the text of session.json. A link, a pipe or a folder of that name is refused, not followed or waited for.
Result<std::string> read_side_file(const fs::path& folder) {
  const fs::path path = folder / "session.json";
  std::error_code failed;
  const fs::file_status status = fs::symlink_status(path, failed);
  if (fs::exists(status) && !fs::is_regular_file(status))
    return Error{"cannot read " + path.string() + ": expected a file"};
  return read_file(path, kMaxSessionJsonBytes);
}

bool is_stream(const FolderEntry& entry) {
  return entry.kind == FolderEntry::Kind::file && !entry.name.starts_with('.') && entry.name.ends_with(".mcap");
}

/// Sets the facts of a session. Returns an Error if neither session.json nor a file has any.
Result<void> take_facts(const std::vector<ReadFile>& files, Session& session) {
  const Result<std::string> text = read_side_file(session.folder);
  if (!text && std::ranges::none_of(files, [](const ReadFile& file) { return file.facts.has_value(); }))
    return text.failure("session " + session.folder.string());
  session.info = info_of(files);
  if (!text) {
    session.rebuilt = text.error();
    return {};
  }
  SessionInfo written;
  if (const Result<void> taken = take_session_info(*text, written)) {
    session.info = std::move(written);
  } else {
    session.rebuilt = taken.error();
    (void)take_session_info(*text, session.info);
  }
  return {};
}

/// Sets the state, the size and the times of a session from its streams and the times of all messages.
void sum_up(Session& session, std::vector<TimeGroup> times) {
  for (const StreamFile& stream : session.streams) {
    session.size_bytes += stream.size_bytes;
    if (!stream.damage.empty() && session.state == SessionState::complete) {
      session.state = SessionState::damaged;
      session.message = stream.damage;
    }
  }
  const TimeSpan span = time_span(std::move(times));
  session.start_ns = span.end_ns > 0 ? span.start_ns : session.info.start_ns;
  session.end_ns = span.end_ns > 0 ? span.end_ns : session.info.start_ns;
  if (session.state == SessionState::complete && session.info.account && session.info.account->dropped > 0)
    session.message = "messages lost while it was recorded: " + std::to_string(session.info.account->dropped);
  if (session.state == SessionState::recovered)
    session.message = "the recording ended without warning; what was on the disk by then is readable";
  leave_out_retained(session, session.info.start_ns);
  session.message = sentences_of({session.message, span.note()});
}

std::uint64_t after_epoch(std::int64_t time_ns) {
  return static_cast<std::uint64_t>(std::max<std::int64_t>(time_ns, 0));
}

}  // namespace

std::string_view name(SessionState state) {
  switch (state) {
    case SessionState::recording: return "recording";
    case SessionState::complete: return "complete";
    case SessionState::recovered: return "recovered";
    case SessionState::damaged: return "damaged";
  }
  return "?";
}

fs::path plain_path(const fs::path& path) {
  fs::path plain = path.lexically_normal();
  std::error_code failed;
  if (plain == "." || plain == "./" || plain.filename() == "..") plain = fs::absolute(plain, failed).lexically_normal();
  return plain.has_filename() || !plain.has_relative_path() ? plain : plain.parent_path();
}

fs::path log_folder_of(const fs::path& path) { return absolute_path(path).parent_path(); }

Result<Session> read_session(const fs::path& folder, bool being_written) {
  Session session{.folder = plain_path(folder)};
  std::vector<ReadFile> files;
  if (const auto entries = list_folder(session.folder)) {
    for (const FolderEntry& entry : *entries) {
      if (is_stream(entry)) files.push_back(read_stream(session.folder / entry.name, entry.size_bytes));
      if (is_stream(entry) || (entry.name == "session.json" && files.empty()))
        session.changed_ns = std::max(session.changed_ns, after_epoch(entry.changed_ns));
    }
  }
  if (const Result<void> taken = take_facts(files, session); !taken) return taken.failure();
  std::vector<TimeGroup> times;
  for (ReadFile& file : files) {
    session.streams.push_back(std::move(file.stream));
    times.insert(times.end(), file.times.begin(), file.times.end());
  }

  session.state = being_written           ? SessionState::recording
                  : session.info.complete ? SessionState::complete
                                          : SessionState::recovered;
  sum_up(session, std::move(times));
  return session;
}

Result<Session> read_recording(const fs::path& path) {
  const auto file = McapFile::open(path);
  if (!file) return file.failure();
  const McapIndex& index = (*file)->index();

  Session session{.folder = path.parent_path(), .info = info_of(index, path)};
  session.one_file = *file;
  session.numbered = session_info_in(index.metadata).has_value();
  session.state = index.damage.empty() ? SessionState::complete : SessionState::damaged;
  session.size_bytes = index.size_bytes;
  const TimeSpan span = time_span((*file)->source(), index);
  session.start_ns = session.info.start_ns = span.start_ns;
  session.end_ns = span.end_ns;
  session.message = sentences_of({index.damage, span.note()});
  for (TopicStream& stream : topic_streams(index))
    session.streams.push_back({.topic = stream.info.topic,
                               .file = path.filename().string(),
                               .schema = stream.info.schema.name,
                               .messages = stream.messages,
                               .start_ns = session.start_ns,
                               .end_ns = session.end_ns,
                               .left_out = stream.left_out,
                               .note = std::move(stream.note)});
  if (const std::optional<SessionInfo> facts = session_info_in(index.metadata))
    leave_out_retained(session, facts->start_ns);
  session.info.start_ns = session.start_ns;
  return session;
}

Result<Session> open_session(const fs::path& path) {
  std::error_code ignored;
  return fs::is_regular_file(path, ignored) ? read_recording(path) : read_session(path);
}

}  // namespace robot::logging
