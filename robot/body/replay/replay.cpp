#include "robot/body/replay/replay.h"

#include <algorithm>
#include <optional>
#include <system_error>
#include <utility>

#include "robot/logging/file_provider.h"

namespace robot::body {

Result<std::unique_ptr<Replay>> Replay::open(const std::filesystem::path& path, ReplayOptions options) {
  if (!(options.speed >= 0.01 && options.speed <= 1000))
    return Error{"replay: speed must be 0.01 .. 1000, got " + std::to_string(options.speed)};
  std::error_code ignored;
  const bool one_file = std::filesystem::is_regular_file(path, ignored);
  Result<logging::Session> session = one_file ? logging::read_recording(path) : logging::read_session(path);
  if (!session) return Error{session.error()};
  std::uint64_t messages = 0;
  for (const logging::StreamFile& stream : session->streams) messages += stream.messages;
  if (messages == 0) return Error{"replay: expected a session with messages, " + path.string() + " has none"};
  return std::unique_ptr<Replay>(new Replay(std::move(*session), one_file, std::move(options)));
}

Replay::~Replay() { stop(); }

void Replay::start(memory::Channels& channels, logging::LoggingBoard& board) {
  channels_ = &channels;
  board_ = &board;
  start_parsers();
}

bool Replay::skipped(const std::string& topic) const {
  return std::ranges::any_of(options_.skipped_objects,
                             [&](const std::string& object) { return topic.ends_with("/" + object); });
}

/// The channel of a stream's topic; made when nobody has it yet.
Result<std::shared_ptr<memory::Channel>> Replay::destination(memory::ChannelInfo info) const {
  const std::string recorded = "/" + session_.info.robot + "/";
  if (!options_.robot.empty() && info.topic.starts_with(recorded))
    info.topic = "/" + options_.robot + "/" + info.topic.substr(recorded.size());
  if (std::shared_ptr<memory::Channel> known = channels_->find(info.topic)) return known;
  auto made = std::make_shared<memory::RawChannel>(std::move(info), clock_);
  if (Result<void> added = channels_->add(made); !added) return Error{added.error()};
  return std::shared_ptr<memory::Channel>(made);
}

void Replay::start_parsers() {
  clock_.start();
  // not owned: the parsers end before the clock does
  const std::shared_ptr<logging::Pace> pace(std::shared_ptr<void>(), &clock_);
  for (const logging::StreamFile& stream : session_.streams) {
    if (stream.messages == 0 || skipped(stream.topic)) continue;
    parsers_.push_back(board_->start_parser(
        std::make_unique<logging::FileInProvider>(session_.folder / stream.file,
                                                  one_file_ ? std::optional(stream.topic) : std::nullopt),
        {.destination = [this](const memory::ChannelInfo& info) { return destination(info); }, .pace = pace}));
  }
}

void Replay::stop_parsers() {
  clock_.stop();
  for (const auto parser : std::exchange(parsers_, {})) board_->stop(parser);
}

Replay::Tick Replay::tick() {
  if (std::ranges::any_of(parsers_, [this](auto parser) { return !board_->status(parser).ended; }))
    return Tick::playing;
  if (!options_.loop) return Tick::ended;
  stop_parsers();
  start_parsers();
  return Tick::began_again;
}

void Replay::stop() {
  if (board_) stop_parsers();
}

std::uint64_t Replay::messages() const {
  std::uint64_t messages = 0;
  for (const auto parser : parsers_) messages += board_->status(parser).messages;
  return messages;
}

}  // namespace robot::body
