// Plays a session into the channels of this process, as if its robot were live.
#pragma once

#include <cstdint>
#include <filesystem>
#include <memory>
#include <string>
#include <vector>

#include "robot/body/replay/playback_clock.h"
#include "robot/core/result.h"
#include "robot/logging/board.h"
#include "robot/logging/session.h"
#include "robot/memory/channels.h"

namespace robot::body {

struct ReplayOptions {
  double speed = 1;   // 1 is real time; 0.01 .. 1000
  bool loop = false;  // begin again at the end

  /// The name under which the recorded robot appears here, "14/2"; empty: its own.
  std::string robot;

  /// Objects that this process writes itself, such as "runtime": those of the recording are left out.
  std::vector<std::string> skipped_objects;
};

/// One parser per stream of the session, all by one clock. Each stream goes into the channel of its topic; a topic that
/// nobody here knows becomes a channel of its own. Used by one thread, except the clock.
class Replay {
 public:
  /// Opens the session in the folder `path`, or the recording of many channels in the file of that name.
  /// An Error if there is none, if it holds no message or if the speed is out of range.
  static Result<std::unique_ptr<Replay>> open(const std::filesystem::path& path, ReplayOptions options);

  /// As stop().
  ~Replay();

  const logging::Session& session() const { return session_; }

  /// The time base for whoever shows what is played: the recording's own time.
  const Clock& clock() const { return clock_; }

  /// Begins to play into `channels`; both outlive this.
  void start(memory::Channels& channels, logging::LoggingBoard& board);

  enum class Tick { playing, ended, began_again };

  /// To be called now and then: begins again at the end if it should.
  Tick tick();

  void stop();

  /// Messages played since the last start.
  std::uint64_t messages() const;

 private:
  Replay(logging::Session session, bool one_file, ReplayOptions options)
      : session_(std::move(session)),
        one_file_(one_file),
        options_(std::move(options)),
        clock_(session_.start_ns, session_.end_ns, options_.speed) {}

  bool skipped(const std::string& topic) const;
  Result<std::shared_ptr<memory::Channel>> destination(memory::ChannelInfo info) const;
  void start_parsers();
  void stop_parsers();

  const logging::Session session_;
  const bool one_file_;  // holds all streams
  const ReplayOptions options_;
  PlaybackClock clock_;
  memory::Channels* channels_ = nullptr;
  logging::LoggingBoard* board_ = nullptr;
  std::vector<logging::LoggingBoard::StreamId> parsers_;
};

}  // namespace robot::body
