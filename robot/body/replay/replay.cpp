#include "robot/body/replay/replay.h"

#include <algorithm>
#include <utility>

#include "robot/logging/file_provider.h"

namespace robot::body {
namespace {

using DestinationResult = Result<std::shared_ptr<memory::Channel>>;

/// The channel of the stream's topic; made when nobody has it yet.
DestinationResult destination(memory::Channels& channels, const Clock& clock, const memory::ChannelInfo& info) {
  if (std::shared_ptr<memory::Channel> known = channels.find(info.topic)) return known;
  auto made = std::make_shared<memory::RawChannel>(info, clock);
  if (Result<void> added = channels.add(made); !added) return Error{added.error()};
  return std::shared_ptr<memory::Channel>(made);
}

}  // namespace

Result<std::unique_ptr<Replay>> Replay::open(const std::filesystem::path& folder, ReplayOptions options) {
  if (!(options.speed >= 0.01 && options.speed <= 1000))
    return Error{"replay: speed must be 0.01 .. 1000, got " + std::to_string(options.speed)};
  Result<logging::Session> session = logging::read_session(folder);
  if (!session) return Error{session.error()};
  std::uint64_t messages = 0;
  for (const logging::StreamFile& stream : session->streams) messages += stream.messages;
  if (messages == 0) return Error{"replay: expected a session with messages, " + folder.string() + " has none"};
  return std::unique_ptr<Replay>(new Replay(std::move(*session), std::move(options)));
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

void Replay::start_parsers() {
  clock_.start();
  // not owned: the parsers end before the clock does
  const std::shared_ptr<logging::Pace> pace(std::shared_ptr<void>(), &clock_);
  for (const logging::StreamFile& stream : session_.streams) {
    if (stream.messages == 0 || skipped(stream.topic)) continue;
    parsers_.push_back(board_->start_parser(
        std::make_unique<logging::FileInProvider>(session_.folder / stream.file),
        {.destination = [this](const memory::ChannelInfo& info) { return destination(*channels_, clock_, info); },
         .pace = pace}));
  }
}

void Replay::stop_parsers() {
  clock_.stop();
  for (const auto parser : std::exchange(parsers_, {})) board_->stop(parser);
}

bool Replay::tick() {
  const bool playing =
      std::ranges::any_of(parsers_, [this](auto parser) { return !board_->status(parser).ended; });
  if (playing || !options_.loop) return playing;
  stop_parsers();
  start_parsers();
  return true;
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
