// Playback of recordings into the channels of this process, as if their robots were live.
#pragma once

#include <atomic>
#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <functional>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "robot/body/replay/file_player.h"
#include "robot/body/replay/playback_clock.h"
#include "robot/body/replay/track.h"
#include "robot/core/clock_shift.h"
#include "robot/core/lock.h"
#include "robot/core/result.h"
#include "robot/logging/sessions/session.h"
#include "robot/logging/streams/board.h"
#include "robot/memory/channels.h"

namespace robot::body {

/// A stream that is made from a recorded one.
struct MadeStream {
  std::string from, to;  // topics: in the recording, and in playback
  std::function<std::unique_ptr<logging::InProvider>(std::unique_ptr<logging::InProvider>)> make;
};

/// Options of a playback.
struct ReplayOptions {
  double speed = 1;   // 1 is real time; 0.01 .. 1000
  bool loop = false;  // restart at the end

  /// Name of the recorded robot in playback, such as "14/2"; empty: its recorded name. For one session only.
  std::string robot;

  /// Shifts of the times of each recording, in the order of the paths; empty: no shifts.
  std::vector<ClockShift> shifts;

  /// Streams that are played in addition to the recorded ones.
  std::vector<MadeStream> made;

  /// Objects of the recording that are not played because this process writes them itself, such as "runtime".
  std::vector<std::string> skipped_objects;
};

/// A playback with one parser for each file: a stream of a session, or a whole file with many topics, which is read
/// once. A made stream has a parser of its own. All parsers use one clock, so recordings of several robots are merged
/// by capture time. Each stream goes into the channel of its topic; an unknown topic gets a new channel. Used by one
/// thread, except the clock.
class Replay {
 public:
  /// Opens `paths`: folders of sessions, or files that hold many channels.
  ///
  /// Returns an Error if:
  /// - there is no path, or the speed is out of range;
  /// - a recording has no message, or no topic beyond those of the recordings before it;
  /// - a made stream's source topic is missing, its target topic exists already, or it cannot be opened.
  static Result<std::unique_ptr<Replay>> open(const std::vector<std::filesystem::path>& paths, ReplayOptions options);

  /// Calls stop().
  ~Replay();

  /// Opens the stream of a topic for another reader, with the times of the playback. Returns null if there is no such
  /// topic. Any thread.
  std::unique_ptr<logging::InProvider> stream_of(const std::string& topic) const;

  /// A message of read().
  struct Message {
    std::size_t topic;         // index in the requested topics
    std::uint64_t capture_ns;  // by the time of the playback
    const std::string& bytes;
  };

  /// Returns the topics of all streams with messages.
  std::vector<std::string> topics() const;

  /// Passes the messages of `topics` that were captured from `from_ns` to `to_ns`, both included, to `visit`, until it
  /// returns false. Each file is read once. The messages of one topic come in its order; different topics may come one
  /// after the other. Made streams are read too; topics that are not played have no messages. Returns the number of
  /// damaged places that were passed over. Any thread, also during the playback.
  std::uint64_t read(const std::vector<std::string>& topics, std::uint64_t from_ns, std::uint64_t to_ns,
                     const std::function<bool(const Message&)>& visit) const;

  /// Returns the name of the track that holds `topic`, or nothing if the topic is not played. The topics of a file with
  /// many topics share a track, so that one reader reads the file once. Any thread.
  std::optional<std::string> track_name(const std::string& topic) const;

  /// Opens a reader of `topics`, which share a track. Returns an Error if the file cannot be read. It ends early when
  /// `cancelled` becomes true. Any thread, also during the playback.
  Result<std::unique_ptr<Track>> open_track(const std::vector<std::string>& topics,
                                            const std::atomic<bool>& cancelled) const;

  /// Returns a sentence for each recording that is damaged or of which messages are left out.
  std::vector<std::string> notes() const;

  /// Returns the robots that recorded, in the order of the paths.
  std::vector<std::string> robots() const;

  /// Returns the rules of the recorded game that the first session with some names, or an empty string.
  std::string rules() const;

  /// Returns the time base for viewers: the recordings' own time, which may be paused and moved.
  PlaybackClock& clock() { return clock_; }
  std::uint64_t start_ns() const { return start_ns_; }  // [ns since the epoch]
  std::uint64_t end_ns() const { return end_ns_; }

  /// Starts to play into `channels`. Both arguments outlive this. Returns an Error if the system allows no more threads.
  Result<void> start(memory::Channels& channels, logging::LoggingBoard& board);

  enum class Tick { playing, ended, began_again };

  /// Checks for the end, and restarts there in a loop. Call it regularly. The end is reached when every message was
  /// played.
  Tick tick();

  /// Ends the playback, also of a reader that is reading now. The readers of stream_of() find no further message in a
  /// file with many topics.
  void stop();

  /// Returns the number of messages played since the start.
  std::uint64_t messages() const;

 private:
  struct Recording {
    logging::Session session;
    ClockShift shift;  // of its times

    std::uint64_t start_ns() const { return shift(session.start_ns); }
    std::uint64_t end_ns() const { return shift(session.end_ns); }
  };

  Replay(std::vector<Recording> recordings, ReplayOptions options);

  /// One stream of the playback.
  struct Played {
    const Recording* recording;
    const logging::StreamFile* file;
    const MadeStream* made;  // the conversion; null: played unchanged
  };

  static Result<Recording> open_recording(const std::filesystem::path& path);
  bool skipped(const std::string& topic) const;
  std::string renamed(const Recording& from, const std::string& topic) const;
  std::string name_of(const Played& stream) const;
  std::vector<Played> played() const;
  std::unique_ptr<logging::InProvider> open_stream(const Played& stream) const;
  std::optional<Played> find(const std::string& topic) const;
  Result<std::shared_ptr<const logging::McapFile>> file_of(const Played& stream) const;
  Result<void> check_made() const;
  Result<void> start_file(const Recording& recording);
  Result<std::shared_ptr<memory::Channel>> destination(const Recording& from, memory::ChannelInfo info);

  const std::vector<Recording> recordings_;
  const ReplayOptions options_;
  const std::uint64_t start_ns_, end_ns_;
  PlaybackClock clock_;
  memory::Channels* channels_ = nullptr;
  logging::LoggingBoard* board_ = nullptr;
  std::vector<logging::LoggingBoard::StreamId> parsers_;
  std::vector<std::unique_ptr<FilePlayer>> players_;

  mutable Mutex files_lock_;
  mutable std::map<std::filesystem::path, std::weak_ptr<const logging::McapFile>> files_;  // open for tracks
};

}  // namespace robot::body
