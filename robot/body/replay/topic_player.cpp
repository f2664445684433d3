#include "robot/body/replay/topic_player.h"

#include <mutex>
#include <utility>

#include "robot/core/attempt.h"
#include "robot/core/report.h"
#include "robot/core/thread.h"

namespace robot::body {

TopicPlayer::TopicPlayer(const Replay& replay, double speed, std::uint64_t from_ns)
    : replay_(replay), end_ns_(replay.end_ns()), clock_(replay.start_ns(), replay.end_ns(), speed) {
  clock_.seek(from_ns);
}

TopicPlayer::~TopicPlayer() {
  stopping_.store(true, std::memory_order_relaxed);
  clock_.stop();
  if (thread_.joinable()) thread_.join();
}

Result<void> TopicPlayer::start() {
  return start_thread(thread_, "playhead", [this] { run(); });
}

void TopicPlayer::seek(std::uint64_t to_ns) {
  const std::lock_guard guard(lock_);
  sought_ = true;
  clock_.seek(to_ns);
}

std::shared_ptr<memory::Channel> TopicPlayer::watch(const memory::ChannelInfo& info) {
  const std::optional<std::string> track = replay_.track_name(info.topic);
  if (!track) return nullptr;
  const std::lock_guard guard(lock_);
  Watched& watched = watched_[info.topic];
  if (++watched.watches > 1) return watched.channel;
  watched.channel = std::make_shared<memory::RawChannel>(info, clock_);
  watched.track = *track;
  changed_.insert(*track);
  clock_.look_again();
  return watched.channel;
}

void TopicPlayer::unwatch(const std::string& topic) {
  const std::lock_guard guard(lock_);
  const auto found = watched_.find(topic);
  if (found == watched_.end() || --found->second.watches > 0) return;
  changed_.insert(found->second.track);
  watched_.erase(found);
  clock_.look_again();
}

void TopicPlayer::run() {
  become_background_thread("playhead");
  const Result<void> played = attempt("playing a recording", [&] { play(); });
  if (!played) report(Level::error, "recording", played.error());
}

/// Carries messages until the clock is stopped.
void TopicPlayer::play() {
  std::uint64_t moves = 0;
  while (true) {
    Playing* const playing = first();
    const auto due =
        playing ? clock_.wait_until_due(playing->next->record.capture_ns, moves) : clock_.wait_for_move(moves);
    if (due == logging::Pace::Due::never) return;
    if (due == logging::Pace::Due::elsewhere) {
      moves = follow();
      continue;
    }
    if (!is_known(*playing)) write(*playing);
    playing->next = playing->track->next();
  }
}

/// Returns whether the channel of the next message has it already, because its track was opened anew for more topics.
bool TopicPlayer::is_known(const Playing& playing) {
  const auto& [topic, record] = *playing.next;
  if (record.capture_ns > playing.known_until_ns) return false;
  const memory::VersionPtr newest = playing.channels[topic]->newest();
  return newest && newest->capture_ns() == record.capture_ns;
}

void TopicPlayer::write(const Playing& playing) {
  const auto& [topic, record] = *playing.next;
  memory::Channel& channel = *playing.channels[topic];
  const Result<void> entered = attempt("a message", [&channel, &bytes = record.bytes, capture_ns = record.capture_ns] {
    return channel.write_bytes(bytes, capture_ns);
  });
  if (!entered) report(Level::error, "recording", entered.error());
}

/// Returns the track whose next message comes first, or null if all are at their end.
TopicPlayer::Playing* TopicPlayer::first() {
  Playing* first = nullptr;
  for (auto& [name, playing] : playing_)
    if (playing.next && (!first || playing.next->record.capture_ns < first->next->record.capture_ns)) first = &playing;
  return first;
}

/// Obeys the changes since the last call: opens the tracks whose topics changed, and moves all of them after a seek.
/// Returns the count of moves that it knows.
std::uint64_t TopicPlayer::follow() {
  std::set<std::string> changed;
  bool sought = false;
  logging::Pace::Move move;
  {
    const std::lock_guard guard(lock_);
    changed = std::exchange(changed_, {});
    sought = std::exchange(sought_, false);
    move = clock_.last_move();
  }
  for (const std::string& track : changed) open_anew(track);
  for (auto& [name, playing] : playing_) {
    if (!sought && !changed.contains(name)) continue;
    playing.track->seek(move.to_ns);
    playing.next = playing.track->next();
    playing.known_until_ns = sought ? 0 : move.to_ns;
  }
  return move.count;
}

/// Opens a track for the topics of it that are watched now, or closes it if there are none.
void TopicPlayer::open_anew(const std::string& track) {
  std::vector<std::string> topics;
  Playing playing;
  {
    const std::lock_guard guard(lock_);
    for (const auto& [topic, watched] : watched_) {
      if (watched.track != track) continue;
      topics.push_back(topic);
      playing.channels.push_back(watched.channel);
    }
  }
  playing_.erase(track);
  if (topics.empty()) return;
  auto opened = replay_.open_track(topics, stopping_);
  if (!opened) return report(Level::error, "recording", opened.error());
  playing.track = std::move(*opened);
  playing_.emplace(track, std::move(playing));
}

}  // namespace robot::body
