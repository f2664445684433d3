// The recorder of every channel of this process into a session.
#pragma once

#include <atomic>
#include <cstdint>
#include <functional>
#include <list>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "robot/core/clock.h"
#include "robot/core/lock.h"
#include "robot/core/result.h"
#include "robot/logging/mcap/compression.h"
#include "robot/logging/sessions/owned_folder.h"
#include "robot/logging/sessions/profile.h"
#include "robot/logging/sessions/session.h"
#include "robot/logging/sessions/session_store.h"
#include "robot/logging/streams/board.h"
#include "robot/memory/channels.h"

namespace robot::logging {

struct RecordingStatus {
  /// `disk_full`: the disk takes no bytes, because it is full, broken or cannot be used. `message` gives the reason.
  enum class State { off, recording, disk_full };

  // when off, the other facts are those of the last request at its end
  State state = State::off;
  std::uint64_t request = 0;  // number of the start() or want(); 0: none yet
  std::string session;        // id; empty: it has not begun
  std::string profile;
  std::uint64_t messages = 0;  // in the files of the session, so that a reader finds them
  std::uint64_t waiting = 0;   // on the way to the files; the death of the process costs these
  std::uint64_t dropped = 0;   // lost since the request: also in deleted files, and while no session could begin
  std::uint64_t size_bytes = 0;
  double mb_per_minute = 0;  // [10^6 bytes] as announced by the profile
  std::string message;       // one sentence about a problem or advice, or empty
};

std::string_view name(RecordingStatus::State state);

/// The owner of one logger and one file per channel. It starts them and closes them. Any thread. status() never waits for the
/// disk: while a session begins or ends, it returns the status before.
///
/// A full or broken disk does not end the recording. The recorder counts the refused messages and reports the state,
/// and it continues when the disk accepts bytes again. If the files of the session are deleted or replaced, it counts
/// their messages as dropped and begins a new session of the same name.
///
/// The times of a session are those of the clock, which a step of the system clock does not move. The folder's name is the
/// time of day, and session.json says how far the times are behind it, as known at the end.
///
/// Each version that the profile wants, from the request to the end, is counted once: as a message in a file or as dropped.
/// A new session begins with the newest version, which the one before has too. Each session holds its account in
/// session.json, also if its folder was moved. If the disk takes no session.json at the end, tend() writes it later.
class Recorder {
 public:
  /// The origin that is written into the sessions. The recorder sets `name`, `profile`, `only`, `start_ns`,
  /// `behind_ns`, `number` and `boot`.
  struct Origin {
    SessionInfo info;
    Compression compression = Compression::lz4;
    std::function<std::int64_t()> behind_ns = {};  // how far the clock is behind the time of day now; may be empty
  };

  /// A stream that failed and has nothing to write since counts as healthy if another one reached the disk this long
  /// after the failure [ns]. A stream that has messages fails more often on a full disk.
  static constexpr std::uint64_t kMendedNs = 3 * kSecond;

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

  /// Makes room, begins a session and returns its id. Returns an Error if a session is being recorded already, if less
  /// than one minute fits, or if `name` cannot name a session. `only` names the objects to record, as object_names()
  /// returns them; without names the recorder records all.
  Result<std::string> start(std::string_view name, std::string_view profile, std::vector<std::string> only = {});

  /// As start(), but if the disk does not permit a session now, the recorder begins it as soon as the disk does. Returns
  /// the number of the request. Returns an Error for a wrong name or profile, or if a session is being recorded already.
  Result<std::uint64_t> want(std::string_view name, std::string_view profile, std::vector<std::string> only = {});

  /// Returns the names of all present objects, once each and ascending: "ball" for "/14/2/ball", "truth/world" for
  /// "/truth/world".
  std::vector<std::string> object_names() const;

  /// Sets the rules of sessions whose origin names none: of the present one, its later files, and later sessions. Rules
  /// that are known already stay.
  void know_rules(const std::string& rules);

  /// Begins a wanted session if that is possible now. Begins a new session if files of the present one were deleted or
  /// replaced. Writes the ends of sessions that the disk did not take before. Called about once a second.
  void tend();

  /// Closes the session and returns its id, which is empty if it never began. Returns an Error if none is wanted.
  Result<std::string> stop();

  RecordingStatus status() const;

 private:
  struct Stream {
    LoggingBoard::StreamId id;
    std::string topic, file;
    std::optional<std::uint64_t> until;  // number of the newest version before that is not missed; empty: no matter
    std::uint64_t identity = 0;          // of its file, as tend() saw it first; 0: not seen yet
  };

  /// A session that somebody asked for.
  struct Wish {
    std::string name;
    Profile profile;
    std::string problem;                 // reason why it has not begun, or empty
    std::vector<std::string> only = {};  // names of the objects; empty: all
  };

  /// A session that has ended, with the facts that the disk has not taken yet.
  struct End {
    OwnedFolder folder;
    SessionInfo info;
    bool reported = false;  // that the disk does not take them
  };

  Result<Wish> accept(std::string_view name, std::string_view profile, std::vector<std::string> only) const;
  void take(Wish wish);
  Result<void> begin();
  Result<void> describe(const Wish& wish, const OwnedFolder& folder, SessionInfo& info) const;
  std::int64_t behind_ns() const;
  void try_to_begin();
  void add(const std::shared_ptr<memory::Channel>& channel);
  bool wants(const memory::Channel& channel) const;
  bool wants_all(const memory::Channel& channel) const;
  std::uint64_t missed(bool begins) const;
  static std::uint64_t missed_before(const Stream& stream, const StreamStatus& carried);
  static bool is_lost(const OwnedFolder& folder, Stream& stream, const StreamStatus& carried);
  bool is_whole();
  SessionAccount end();
  void write_ends();
  void write_news();
  void give_up();
  RecordingStatus status_now() const;

  memory::Channels& channels_;
  LoggingBoard& board_;
  SessionStore& store_;
  const Clock& clock_;
  const Origin origin_;
  memory::Channels::WatcherId watcher_;

  Mutex work_;           // held by functions that use the disk; each change below needs it
  std::list<End> ends_;  // used only with work_

  mutable Mutex lock_;  // guards the rest for status() and for channels that appear; never held while the disk works
  std::optional<RecordingStatus> shown_;  // while a session begins or ends
  std::optional<Wish> wish_;
  std::uint64_t request_ = 0;
  std::optional<OwnedFolder> folder_;        // of the session that is being recorded
  std::shared_ptr<std::atomic<bool>> gone_;  // of the streams: the folder is no longer in its place
  SessionInfo info_;
  bool has_news_ = false;               // info_ has facts that session.json lacks
  std::string rules_;                   // of the origin, or learnt later
  std::string session_, profile_name_;  // the present or last one
  std::vector<Stream> streams_;
  std::uint64_t dropped_ = 0;  // since the request, before the present session
  // by topic, since a wanted session could not begin or a session ended: number of the newest version that is not missed
  std::map<std::string, std::uint64_t> until_;
  std::string advice_;
  std::string loss_;      // one sentence about files that were deleted since the request, or empty
  RecordingStatus last_;  // of the last request, at its end
};

}  // namespace robot::logging
