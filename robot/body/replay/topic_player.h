// A playhead of its own in a recording, which plays only the topics that are watched.
#pragma once

#include <atomic>
#include <cstdint>
#include <map>
#include <memory>
#include <optional>
#include <set>
#include <string>
#include <thread>
#include <vector>

#include "robot/body/replay/playback_clock.h"
#include "robot/body/replay/replay.h"
#include "robot/body/replay/track.h"
#include "robot/core/lock.h"
#include "robot/core/result.h"
#include "robot/memory/channel.h"

namespace robot::body {

/// A thread that plays the watched topics of a recording into channels of its own, by a clock of its own. It moves no
/// other playback of the recording. After a move of the playhead each channel gets its newest message before the new
/// time; a topic that is watched anew gets it at once. It holds one open reader for each track of the watched topics,
/// with one chunk of each file or up to 16 MB more of a file with overlapping chunks. All functions from any thread.
class TopicPlayer {
 public:
  /// Begins paused at `from_ns`, limited to the recording. `replay` outlives this.
  TopicPlayer(const Replay& replay, double speed, std::uint64_t from_ns);

  /// Ends the thread, also while it reads.
  ~TopicPlayer();

  /// Starts the thread, once. Returns an Error if the system allows no more threads.
  Result<void> start();

  PlaybackClock& clock() { return clock_; }
  const PlaybackClock& clock() const { return clock_; }

  /// Moves the playhead to `to_ns`, limited to the recording.
  void seek(std::uint64_t to_ns);

  /// Plays the topic of `info` from now on into the returned channel. Returns null if the recording does not have it.
  /// Several watches of a topic share a channel.
  std::shared_ptr<memory::Channel> watch(const memory::ChannelInfo& info);

  /// Ends one watch of `topic`. The last one closes its reader.
  void unwatch(const std::string& topic);

  /// Returns whether the end is reached and every message was played.
  bool at_end() const { return clock_.now_ns() >= end_ns_ && clock_.parsers_at_end() > 0; }

 private:
  struct Watched {
    std::shared_ptr<memory::Channel> channel;
    std::string track;
    int watches = 0;
  };
  /// One open track with its next message. `channels` are those of its topics.
  struct Playing {
    std::unique_ptr<Track> track;
    std::vector<std::shared_ptr<memory::Channel>> channels;
    std::optional<Track::Message> next;
    std::uint64_t known_until_ns = 0;  // up to here its channels may have messages that come again
  };

  void run();
  void play();
  std::uint64_t follow();
  void open_anew(const std::string& track);
  Playing* first();
  static bool is_known(const Playing& playing);
  static void write(const Playing& playing);

  const Replay& replay_;
  const std::uint64_t end_ns_;
  PlaybackClock clock_;
  std::atomic<bool> stopping_ = false;

  Mutex lock_;                              // guards the next three
  std::map<std::string, Watched> watched_;  // by topic
  std::set<std::string> changed_;           // tracks whose watched topics changed
  bool sought_ = false;                     // the playhead was moved

  std::map<std::string, Playing> playing_;  // by the name of the track; only of the thread
  std::thread thread_;                      // declared last, because it uses all other members
};

}  // namespace robot::body
