// The player of one file with many topics.
#pragma once

#include <atomic>
#include <cstdint>
#include <map>
#include <memory>
#include <set>
#include <thread>
#include <vector>

#include "robot/body/replay/playback_clock.h"
#include "robot/core/clock_shift.h"
#include "robot/logging/mcap/ordered_reader.h"
#include "robot/memory/channel.h"
#include "robot/memory/time_shift.h"

namespace robot::body {

/// The destination of some channels of a file.
struct PlayedTopic {
  std::set<std::uint16_t> channels;  // ids
  std::shared_ptr<memory::Channel> to;
  std::unique_ptr<memory::TimeShift> shift;  // of their times; null: none
};

/// A thread that reads a file once and carries each message into its channel when the clock says so. After a move of
/// the playhead each channel gets its newest message before the new time. It reports a damage and continues after it. A
/// message that its channel refuses is left out; an exception of a channel costs one message, too.
class FilePlayer {
 public:
  /// `shift` is that of all topics. `clock` outlives this.
  FilePlayer(std::shared_ptr<const logging::McapFile> file, std::vector<PlayedTopic> topics, const ClockShift& shift,
             PlaybackClock& clock);

  /// Starts the thread, once. Returns an Error if the system allows no more threads.
  Result<void> start();

  /// As stop().
  ~FilePlayer();

  /// Ends the thread, also while it reads. The clock must be stopped before.
  void stop();

  std::uint64_t messages() const { return messages_.load(std::memory_order_relaxed); }  // played since the start

 private:
  void run();
  void carry();
  void follow(const logging::Pace::Move& move);
  void play(const logging::McapMessage& message);

  std::vector<PlayedTopic> topics_;
  std::map<std::uint16_t, const PlayedTopic*> topic_of_;
  const ClockShift shift_;
  PlaybackClock& clock_;
  std::atomic<bool> stopping_ = false;
  logging::OrderedReader reader_;
  std::atomic<std::uint64_t> messages_ = 0;
  std::thread thread_;  // declared last, because it uses all other members
};

}  // namespace robot::body
