#include "robot/body/replay/replay.h"

#include <algorithm>
#include <optional>
#include <set>
#include <system_error>
#include <utility>

#include "robot/logging/file_provider.h"

namespace robot::body {

Result<Replay::Recording> Replay::read(const std::filesystem::path& path) {
  std::error_code ignored;
  const bool one_file = std::filesystem::is_regular_file(path, ignored);
  Result<logging::Session> session = one_file ? logging::read_recording(path) : logging::read_session(path);
  if (!session) return Error{session.error()};
  std::uint64_t messages = 0;
  for (const logging::StreamFile& stream : session->streams) messages += stream.messages;
  if (messages == 0) return Error{"replay: expected a session with messages, " + path.string() + " has none"};
  return Recording{std::move(*session), one_file};
}

Result<std::unique_ptr<Replay>> Replay::open(const std::vector<std::filesystem::path>& paths, ReplayOptions options) {
  if (!(options.speed >= 0.01 && options.speed <= 1000))
    return Error{"replay: speed must be 0.01 .. 1000, got " + std::to_string(options.speed)};
  if (paths.empty()) return Error{"replay: expected a session, got none"};
  std::vector<Recording> recordings;
  std::set<std::string> topics;
  for (const std::filesystem::path& path : paths) {
    Result<Recording> recording = read(path);
    if (!recording) return Error{recording.error()};
    // what several hold, such as the truth, is played once
    std::erase_if(recording->session.streams, [&](const auto& stream) { return !topics.insert(stream.topic).second; });
    if (recording->session.streams.empty())
      return Error{"replay: expected recordings of different robots, " + path.string() +
                   " holds nothing but what those before it do"};
    recordings.push_back(std::move(*recording));
  }
  return std::unique_ptr<Replay>(new Replay(std::move(recordings), std::move(options)));
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

bool Replay::skipped(const std::string& topic) const {
  return std::ranges::any_of(options_.skipped_objects,
                             [&](const std::string& object) { return topic.ends_with("/" + object); });
}

/// The channel of a stream's topic; made when nobody has it yet.
Result<std::shared_ptr<memory::Channel>> Replay::destination(const Recording& from, memory::ChannelInfo info) {
  const std::string recorded = "/" + from.session.info.robot + "/";
  if (!options_.robot.empty() && info.topic.starts_with(recorded))
    info.topic = "/" + options_.robot + "/" + info.topic.substr(recorded.size());
  if (std::shared_ptr<memory::Channel> known = channels_->find(info.topic)) return known;
  auto made = std::make_shared<memory::RawChannel>(std::move(info), clock_);
  if (Result<void> added = channels_->add(made); !added) return Error{added.error()};
  return std::shared_ptr<memory::Channel>(made);
}

void Replay::start(memory::Channels& channels, logging::LoggingBoard& board) {
  channels_ = &channels;
  board_ = &board;
  clock_.start();
  // not owned: the parsers end before the clock does
  const std::shared_ptr<logging::Pace> pace(std::shared_ptr<void>(), &clock_);
  for (const Recording& recording : recordings_)
    for (const logging::StreamFile& stream : recording.session.streams) {
      if (stream.messages == 0 || skipped(stream.topic)) continue;
      parsers_.push_back(board_->start_parser(
          std::make_unique<logging::FileInProvider>(recording.session.folder / stream.file,
                                                    recording.one_file ? std::optional(stream.topic) : std::nullopt),
          {.destination = [this, &recording](const memory::ChannelInfo& info) { return destination(recording, info); },
           .pace = pace}));
    }
}

Replay::Tick Replay::tick() {
  // a parser whose file cannot be read on has ended for good
  const auto gone = std::ranges::count_if(parsers_, [this](auto parser) { return board_->status(parser).ended; });
  if (clock_.parsers_at_end() + static_cast<std::size_t>(gone) < parsers_.size()) return Tick::playing;
  if (!options_.loop) return Tick::ended;
  clock_.seek(start_ns_);
  return Tick::began_again;
}

void Replay::stop() {
  clock_.stop();
  for (const auto parser : std::exchange(parsers_, {})) board_->stop(parser);
}

std::uint64_t Replay::messages() const {
  std::uint64_t messages = 0;
  for (const auto parser : parsers_) messages += board_->status(parser).messages;
  return messages;
}

}  // namespace robot::body
