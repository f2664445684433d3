// Plays recordings into the channels of this process, as if their robots were live.
#pragma once

#include <cstdint>
#include <filesystem>
#include <functional>
#include <memory>
#include <string>
#include <vector>

#include "robot/body/replay/playback_clock.h"
#include "robot/core/result.h"
#include "robot/logging/sessions/session.h"
#include "robot/logging/streams/board.h"
#include "robot/memory/channels.h"

namespace robot::body {

/// A stream that is made of one of a recording.
struct MadeStream {
  std::string from, to;  // topics: of the recording, and as it is played
  std::function<std::unique_ptr<logging::InProvider>(std::unique_ptr<logging::InProvider>)> make;
};

struct ReplayOptions {
  double speed = 1;   // 1 is real time; 0.01 .. 1000
  bool loop = false;  // begin again at the end

  /// The name under which the recorded robot appears here, "14/2"; empty: its own. For one session only.
  std::string robot;

  /// What is to be added to the times of each recording, in the order of their paths [ns]; none: nothing to any.
  std::vector<std::int64_t> shifts_ns;

  /// Played beside the streams that they are made of.
  std::vector<MadeStream> made;

  /// Objects that this process writes itself, such as "runtime": those of the recording are left out.
  std::vector<std::string> skipped_objects;
};

/// One parser per stream, all by one clock: what several robots recorded is merged by capture time. Each stream goes
/// into the channel of its topic; a topic that nobody here knows becomes a channel of its own. Used by one thread,
/// except the clock.
class Replay {
 public:
  /// Opens the sessions in the folders `paths`, or the recordings of many channels in files of that name.
  /// An Error if there is none, if one holds no message, if one has no topic that those before it have not, if the speed
  /// is out of range, or if a stream cannot be made: none of its topic is there, one of the other topic is, or opening it
  /// fails.
  static Result<std::unique_ptr<Replay>> open(const std::vector<std::filesystem::path>& paths, ReplayOptions options);

  /// As stop().
  ~Replay();

  /// The stream of a topic as it is played, its times included, to be read by somebody else; null where there is none.
  /// Any thread.
  std::unique_ptr<logging::InProvider> stream_of(const std::string& topic) const;

  /// The robots that recorded, in the order in which their recordings were given.
  std::vector<std::string> robots() const;

  /// The time base for whoever shows what is played: the recordings' own time, which may be paused and moved.
  PlaybackClock& clock() { return clock_; }
  std::uint64_t start_ns() const { return start_ns_; }  // [ns since the epoch]
  std::uint64_t end_ns() const { return end_ns_; }

  /// Begins to play into `channels`; both outlive this.
  void start(memory::Channels& channels, logging::LoggingBoard& board);

  enum class Tick { playing, ended, began_again };

  /// To be called now and then: begins again at the end if it should. At the end means that all is carried.
  Tick tick();

  void stop();

  /// Messages played since the start.
  std::uint64_t messages() const;

 private:
  struct Recording {
    logging::Session session;
    std::int64_t shift_ns = 0;  // to be added to its times

    std::uint64_t start_ns() const { return session.start_ns + static_cast<std::uint64_t>(shift_ns); }
    std::uint64_t end_ns() const { return session.end_ns + static_cast<std::uint64_t>(shift_ns); }
  };

  Replay(std::vector<Recording> recordings, ReplayOptions options);

  /// One stream that is played.
  struct Played {
    const Recording* recording;
    const logging::StreamFile* file;
    const MadeStream* made;  // of it; null: as it is
  };

  static Result<Recording> read(const std::filesystem::path& path);
  bool skipped(const std::string& topic) const;
  std::string renamed(const Recording& from, const std::string& topic) const;
  std::vector<Played> played() const;
  std::unique_ptr<logging::InProvider> open_stream(const Played& stream) const;
  Result<void> check_made() const;
  Result<std::shared_ptr<memory::Channel>> destination(const Recording& from, memory::ChannelInfo info);

  const std::vector<Recording> recordings_;
  const ReplayOptions options_;
  const std::uint64_t start_ns_, end_ns_;
  PlaybackClock clock_;
  memory::Channels* channels_ = nullptr;
  logging::LoggingBoard* board_ = nullptr;
  std::vector<logging::LoggingBoard::StreamId> parsers_;
};

}  // namespace robot::body
