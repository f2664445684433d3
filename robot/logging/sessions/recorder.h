// The recorder of every channel of this process into a session.
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
  std::string session;  // id of the present session, or of the last one when off
  std::string profile;
  std::uint64_t messages = 0, dropped = 0;
  std::uint64_t size_bytes = 0;
  double mb_per_minute = 0;  // [10^6 bytes] as announced by the profile
  std::string message;       // one sentence about a problem or advice, or empty
};

std::string_view name(RecordingStatus::State state);

/// The owner of one logger and one file per channel. It starts them and closes them. Any thread.
///
/// A full or broken disk does not end the recording. The recorder counts the refused messages and reports the state,
/// and it continues when the disk accepts bytes again.
class Recorder {
 public:
  /// The origin that is written into the sessions. start() sets `name`, `profile` and `start_ns`.
  struct Origin {
    SessionInfo info;
    Compression compression = Compression::lz4;
  };

  /// All references must outlive the recorder.
  Recorder(memory::Channels& channels, LoggingBoard& board, SessionStore& store, const Clock& clock, Origin origin);

  /// As stop().
  ~Recorder();

  /// The space for a recording.
  struct Room {
    double minutes = 0;
    std::string sentence;  // for people
  };

  /// Returns how many minutes of `profile` fit now, if all deletable sessions are deleted.
  Room room_for(const Profile& profile) const;

  /// Makes room, begins a session and returns its id. Returns an Error if a session is being recorded already, or if
  /// less than one minute fits.
  Result<std::string> start(std::string_view name, std::string_view profile);

  /// Closes the session and returns its id. Returns an Error if none is being recorded.
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
