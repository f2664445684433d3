#include "robot/body/replay/replay.h"

#include <algorithm>
#include <map>
#include <set>
#include <utility>

#include "robot/core/report.h"
#include "robot/logging/mcap/topic_streams.h"
#include "robot/logging/sessions/session_provider.h"
#include "robot/logging/streams/shifted_provider.h"

namespace robot::body {

Result<Replay::Recording> Replay::open_recording(const std::filesystem::path& path) {
  Result<logging::Session> session = logging::open_session(path);
  if (!session) return session.failure();
  std::uint64_t messages = 0;
  for (const logging::StreamFile& stream : session->streams) messages += stream.messages;
  if (messages == 0) return Error{"replay: expected a session with messages, " + path.string() + " has none"};
  return Recording{.session = std::move(*session), .shift = {}};
}

Result<std::unique_ptr<Replay>> Replay::open(const std::vector<std::filesystem::path>& paths, ReplayOptions options) {
  if (!(options.speed >= 0.01 && options.speed <= 1000))
    return Error{"replay: speed must be 0.01 .. 1000, got " + std::to_string(options.speed)};
  if (paths.empty()) return Error{"replay: expected a session, got none"};
  std::vector<Recording> recordings;
  std::set<std::string> topics;
  for (const std::filesystem::path& path : paths) {
    Result<Recording> recording = open_recording(path);
    if (!recording) return recording.failure();
    // a topic in several recordings, such as the truth, is played once
    std::erase_if(recording->session.streams, [&](const auto& stream) { return !topics.insert(stream.topic).second; });
    if (recording->session.streams.empty())
      return Error{"replay: expected recordings of different robots, " + path.string() +
                   " has no topic beyond those before it"};
    if (recordings.size() < options.shifts.size()) recording->shift = options.shifts[recordings.size()];
    recordings.push_back(std::move(*recording));
  }
  auto replay = std::unique_ptr<Replay>(new Replay(std::move(recordings), std::move(options)));
  if (Result<void> makes = replay->check_made(); !makes) return makes.failure();
  return replay;
}

Replay::Replay(std::vector<Recording> recordings, ReplayOptions options)
    : recordings_(std::move(recordings)),
      options_(std::move(options)),
      start_ns_(std::ranges::min_element(recordings_, {}, &Recording::start_ns)->start_ns()),
      end_ns_(std::ranges::max_element(recordings_, {}, &Recording::end_ns)->end_ns()),
      clock_(start_ns_, end_ns_, options_.speed) {}

Replay::~Replay() { stop(); }

std::vector<std::string> Replay::robots() const {
  std::vector<std::string> robots;
  for (const Recording& recording : recordings_)
    robots.push_back(options_.robot.empty() ? recording.session.info.robot : options_.robot);
  return robots;
}

std::string Replay::rules() const {
  for (const Recording& recording : recordings_)
    if (!recording.session.info.rules.empty()) return recording.session.info.rules;
  return {};
}

bool Replay::skipped(const std::string& topic) const {
  return std::ranges::any_of(options_.skipped_objects,
                             [&](const std::string& object) { return topic.ends_with("/" + object); });
}

/// Returns the topic under the name that the recorded robot has here.
std::string Replay::renamed(const Recording& from, const std::string& topic) const {
  const std::string recorded = "/" + from.session.info.robot + "/";
  if (options_.robot.empty() || !topic.starts_with(recorded)) return topic;
  return "/" + options_.robot + "/" + topic.substr(recorded.size());
}

/// Returns the channel of a stream's topic, and creates it if it is missing.
Result<std::shared_ptr<memory::Channel>> Replay::destination(const Recording& from, memory::ChannelInfo info) {
  info.topic = renamed(from, info.topic);
  if (std::shared_ptr<memory::Channel> known = channels_->find(info.topic)) return known;
  auto made = std::make_shared<memory::RawChannel>(std::move(info), clock_);
  if (Result<void> added = channels_->add(made); !added) return added.failure();
  return std::shared_ptr<memory::Channel>(made);
}

/// Returns all streams to play: the recorded ones and those that are made from them.
std::vector<Replay::Played> Replay::played() const {
  std::vector<Played> streams;
  for (const Recording& recording : recordings_)
    for (const logging::StreamFile& file : recording.session.streams) {
      if (file.messages == 0) continue;
      if (!skipped(file.topic)) streams.push_back({.recording = &recording, .file = &file, .made = nullptr});
      for (const MadeStream& made : options_.made)
        if (made.from == file.topic) streams.push_back({.recording = &recording, .file = &file, .made = &made});
    }
  return streams;
}

std::unique_ptr<logging::InProvider> Replay::open_stream(const Played& played) const {
  std::unique_ptr<logging::InProvider> stream = logging::provider_of(played.recording->session, *played.file);
  if (played.made) stream = played.made->make(std::move(stream));
  if (played.recording->shift.is_none()) return stream;
  return std::make_unique<logging::ShiftedInProvider>(std::move(stream), played.recording->shift);
}

std::unique_ptr<logging::InProvider> Replay::stream_of(const std::string& topic) const {
  const std::optional<Played> stream = find(topic);
  return stream ? open_stream(*stream) : nullptr;
}

std::optional<Replay::Played> Replay::find(const std::string& topic) const {
  for (const Played& stream : played())
    if (name_of(stream) == topic) return stream;
  return std::nullopt;
}

/// Returns the topic of a stream in the playback.
std::string Replay::name_of(const Played& stream) const {
  return stream.made ? stream.made->to : renamed(*stream.recording, stream.file->topic);
}

std::vector<std::string> Replay::topics() const {
  std::vector<std::string> topics;
  for (const Played& stream : played()) topics.push_back(name_of(stream));
  return topics;
}

Result<void> Replay::check_made() const {
  std::string topics;
  for (const Recording& recording : recordings_)
    for (const logging::StreamFile& file : recording.session.streams) {
      topics += (topics.empty() ? "" : ", ") + file.topic;
      for (const MadeStream& made : options_.made)
        if (made.to == file.topic)
          return Error{"expected a new topic for " + made.from + ", got " + made.to +
                       ", which the recording has already"};
    }
  const std::vector<Played> streams = played();
  for (const MadeStream& made : options_.made) {
    const auto found = std::ranges::find(streams, &made, &Played::made);
    if (found == streams.end())
      return Error{"expected one of the topics that have messages (" + topics + "), got '" + made.from + "'"};
    if (const auto opened = open_stream(*found)->open(); !opened) return opened.failure();
  }
  return {};
}

std::vector<std::string> Replay::notes() const {
  std::vector<std::string> notes;
  for (const Recording& recording : recordings_) {
    if (!recording.session.message.empty()) notes.push_back(recording.session.message);
    for (const logging::StreamFile& stream : recording.session.streams)
      if (!stream.note.empty()) notes.push_back(stream.note);
  }
  return notes;
}

Result<void> Replay::start(memory::Channels& channels, logging::LoggingBoard& board) {
  channels_ = &channels;
  board_ = &board;
  clock_.start();
  // not owned: the parsers end before the clock does
  const std::shared_ptr<logging::Pace> pace(std::shared_ptr<void>(), &clock_);
  for (const Played& stream : played()) {
    if (stream.recording->session.one_file && !stream.made) continue;
    const auto to = [this, stream](const memory::ChannelInfo& info) { return destination(*stream.recording, info); };
    parsers_.push_back(board_->start_parser(open_stream(stream), {.destination = to, .pace = pace}));
  }
  for (const Recording& recording : recordings_)
    if (recording.session.one_file)
      if (Result<void> started = start_file(recording); !started) return started;
  return {};
}

/// Starts one player for all topics of a file.
Result<void> Replay::start_file(const Recording& recording) {
  std::map<std::string, logging::TopicStream> streams;
  for (logging::TopicStream& stream : logging::topic_streams(recording.session.one_file->index()))
    streams.emplace(stream.info.topic, stream);
  std::vector<PlayedTopic> topics;
  for (const Played& stream : played()) {
    if (stream.recording != &recording || stream.made) continue;
    const logging::TopicStream& of_topic = streams.at(stream.file->topic);
    auto channel = destination(recording, of_topic.info);
    if (!channel) {
      report(Level::error, "logging", channel.error());
      continue;
    }
    PlayedTopic topic{.channels = of_topic.channels, .to = std::move(*channel), .shift = nullptr};
    if (!recording.shift.is_none()) topic.shift = std::make_unique<memory::TimeShift>(of_topic.info, recording.shift);
    topics.push_back(std::move(topic));
  }
  players_.push_back(
      std::make_unique<FilePlayer>(recording.session.one_file, std::move(topics), recording.shift, clock_));
  return players_.back()->start();
}

Replay::Tick Replay::tick() {
  // a parser with a damaged file has ended and does not reach the end
  const auto gone = std::ranges::count_if(parsers_, [this](auto parser) { return board_->status(parser).ended; });
  if (clock_.parsers_at_end() + static_cast<std::size_t>(gone) < parsers_.size() + players_.size())
    return Tick::playing;
  if (!options_.loop) return Tick::ended;
  clock_.seek(start_ns_);
  return Tick::began_again;
}

void Replay::stop() {
  clock_.stop();
  for (const Recording& recording : recordings_)
    if (recording.session.one_file) recording.session.one_file->end_reading();
  for (const auto parser : std::exchange(parsers_, {})) board_->stop(parser);
  for (const auto& player : players_) player->stop();
}

std::uint64_t Replay::messages() const {
  std::uint64_t messages = 0;
  for (const auto parser : parsers_) messages += board_->status(parser).messages;
  for (const auto& player : players_) messages += player->messages();
  return messages;
}

}  // namespace robot::body
