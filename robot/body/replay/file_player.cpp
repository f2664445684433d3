#include "robot/body/replay/file_player.h"

#include <utility>

#include "robot/core/attempt.h"
#include "robot/core/report.h"
#include "robot/core/thread.h"

namespace robot::body {
namespace {

std::set<std::uint16_t> all_channels(const std::vector<PlayedTopic>& topics) {
  std::set<std::uint16_t> all;
  for (const PlayedTopic& topic : topics) all.insert(topic.channels.begin(), topic.channels.end());
  return all;
}

}  // namespace

FilePlayer::FilePlayer(std::shared_ptr<const logging::McapFile> file, std::vector<PlayedTopic> topics,
                       const ClockShift& shift, PlaybackClock& clock)
    : topics_(std::move(topics)),
      shift_(shift),
      clock_(clock),
      reader_(std::move(file), all_channels(topics_), &stopping_) {
  for (const PlayedTopic& topic : topics_)
    for (const std::uint16_t channel : topic.channels) topic_of_[channel] = &topic;
}

Result<void> FilePlayer::start() {
  return start_thread(thread_, "player", [this] { run(); });
}

FilePlayer::~FilePlayer() { stop(); }

void FilePlayer::stop() {
  stopping_.store(true, std::memory_order_relaxed);
  if (thread_.joinable()) thread_.join();
}

void FilePlayer::run() {
  become_background_thread("player");
  const Result<void> played = attempt("playing a file", [&] { carry(); });
  if (!played) report(Level::error, "logging", played.error());
}

/// Carries messages until the clock is stopped.
void FilePlayer::carry() {
  std::uint64_t moves = 0;
  while (true) {
    const auto message = reader_.next();
    if (!message) {
      report(Level::error, "logging", message.error());
      continue;
    }
    const auto due =
        *message ? clock_.wait_until_due(shift_((*message)->record.capture_ns), moves) : clock_.wait_for_move(moves);
    if (due == logging::Pace::Due::never) return;
    if (due == logging::Pace::Due::now) {
      play(**message);
      continue;
    }
    const logging::Pace::Move move = clock_.last_move();
    moves = move.count;
    follow(move);
  }
}

/// Gives each channel its value of the new time and continues after it.
void FilePlayer::follow(const logging::Pace::Move& move) {
  for (const logging::McapMessage& message : reader_.move_to(shift_.back(move.to_ns))) play(message);
}

void FilePlayer::play(const logging::McapMessage& message) {
  const PlayedTopic& topic = *topic_of_.at(message.channel_id);
  const logging::Record& record = message.record;
  const Result<void> entered = attempt("a message", [&] {
    return topic.shift ? topic.to->write_bytes(topic.shift->moved(record.bytes, record.capture_ns),
                                               (*topic.shift)(record.capture_ns))
                       : topic.to->write_bytes(record.bytes, record.capture_ns);
  });
  if (entered) messages_.fetch_add(1, std::memory_order_relaxed);
}

}  // namespace robot::body
