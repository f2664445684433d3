// Records every channel of this process into a session.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "robot/core/clock.h"
#include "robot/core/lock.h"
#include "robot/core/result.h"
#include "robot/logging/mcap/compression.h"
#include "robot/logging/sessions/profile.h"
#include "robot/logging/sessions/session.h"
#include "robot/logging/sessions/session_store.h"
#include "robot/logging/streams/board.h"
#include "robot/memory/channels.h"

namespace robot::logging {

struct RecordingStatus {
  enum class State { off, recording, disk_full };

  State state = State::off;
  std::string session;  // its id; the last one when off
  std::string profile;
  std::uint64_t messages = 0, dropped = 0;
  std::uint64_t size_bytes = 0;
  double mb_per_minute = 0;  // [10^6 bytes] as announced by the profile
  std::string message;       // what is wrong or worth knowing, one sentence, or empty
};

std::string_view name(RecordingStatus::State state);

/// Starts a logger per channel with a file of its own, and ends them in good order. Any thread.
///
/// A disk that is full or broken ends nothing: what it refuses is counted, the state says so, and recording goes on
/// when the disk takes bytes again.
class Recorder {
 public:
  /// What the sessions are said to come from. `name`, `profile`, `start_ns` are set by start().
  struct Origin {
    SessionInfo info;
    Compression compression = Compression::lz4;
  };

  /// The given ones outlive the recorder.
  Recorder(memory::Channels& channels, LoggingBoard& board, SessionStore& store, const Clock& clock, Origin origin);

  /// As stop().
  ~Recorder();

  /// How many minutes of `profile` fit now, after deleting what may be deleted; a sentence for people.
  struct Room {
    double minutes = 0;
    std::string sentence;
  };
  Room room_for(const Profile& profile) const;

  /// Begins a session, after making room; its id. An Error when one is being recorded already, or when not even a
  /// minute of it would fit.
  Result<std::string> start(std::string_view name, std::string_view profile);

  /// Ends the session in good order; its id. An Error if none is being recorded.
  Result<std::string> stop();

  RecordingStatus status() const;

 private:
  struct Stream {
    LoggingBoard::StreamId id;
    std::filesystem::path path;
  };

  void add(const std::shared_ptr<memory::Channel>& channel);

  memory::Channels& channels_;
  LoggingBoard& board_;
  SessionStore& store_;
  const Clock& clock_;
  const Origin origin_;
  memory::Channels::WatcherId watcher_;

  mutable Mutex lock_;
  bool recording_ = false;
  SessionInfo info_;
  std::filesystem::path folder_;
  Profile profile_ = profiles().front();
  std::vector<Stream> streams_;
  std::string advice_;
};

}  // namespace robot::logging
