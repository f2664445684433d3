// The store of all sessions in one log folder.
#pragma once

#include <cstdint>
#include <filesystem>
#include <map>
#include <optional>
#include <set>
#include <string>
#include <utility>
#include <vector>

#include "robot/core/folder.h"
#include "robot/core/lock.h"
#include "robot/core/result.h"
#include "robot/logging/sessions/folder_sizes.h"
#include "robot/logging/sessions/job_thread.h"
#include "robot/logging/sessions/retention.h"
#include "robot/logging/sessions/session.h"

namespace robot::logging {

/// The sessions of a folder: it lists, keeps and deletes them. Any thread. Does not throw.
///
/// It never deletes a session that a living process records, in this program or in another one. A session whose
/// session.json is missing or damaged gets a new one, with the facts in its MCAP files, and is reported once.
/// It follows no symbolic link in the log folder.
class SessionStore {
 public:
  /// `folder` may be missing; recording creates it. All sessions together may take at most `max_bytes`.
  SessionStore(std::filesystem::path folder, std::uint64_t max_bytes);

  const std::filesystem::path& folder() const { return folder_; }
  std::uint64_t max_bytes() const { return max_bytes_; }

  /// Returns all sessions, the newest first. Leaves out folders without a session. Waits until each has been read.
  std::vector<Session> list() const;

  /// As list(), but waits at most `wait_ns` for sessions that another thread then reads: the index of a large recording
  /// without one takes long. Such a session is as it was read last, or as its session.json says, and not marked `read`.
  std::vector<Session> list_within(std::uint64_t wait_ns) const;

  /// Returns the session `id`, or an Error if there is none. Refuses an id that contains a path.
  Result<Session> find(std::string_view id) const;

  /// Sets whether the session is kept, so that make_room() never deletes it.
  Result<void> keep(std::string_view id, bool keep);

  /// Deletes a session of any age. Returns an Error for one that is kept or being written, and for one that contains a
  /// folder, because no recording makes one.
  Result<void> remove(std::string_view id);

  /// Deletes the oldest sessions until `bytes` of the cap are free, and reports each. Deletes only those that
  /// is_deletable() permits; the clocks are `now_ns` and the system's. Returns the ids of the deleted sessions.
  std::vector<std::string> make_room(std::uint64_t bytes, std::uint64_t now_ns);

  /// Returns how much make_room() could free at `now_ns` [bytes].
  std::uint64_t deletable_bytes(std::uint64_t now_ns) const;

  /// Returns the free space on the folder's disk [bytes], or 0 if it is unknown.
  std::uint64_t disk_free_bytes() const;

  /// Returns the size of all sessions [bytes]. Never waits for another function, and costs nothing while all sessions
  /// stay the same.
  std::uint64_t size_bytes() const;

  /// Returns the greatest number of a session in the folder, or 0.
  std::uint64_t greatest_number() const;

 private:
  /// A folder that may hold a session.
  struct Candidate {
    std::filesystem::path folder;
    std::vector<FolderEntry> entries;
    bool described = false;  // has a file session.json
    bool owned = false;      // a living process records it
    std::uint64_t size_bytes = 0;
  };

  /// A session as it was read last.
  struct Known {
    Result<Session> session;
    bool is_current = false;  // its files are the same since
  };

  std::vector<Candidate> candidates() const;
  std::vector<Candidate> session_candidates() const;
  Candidate candidate(const std::string& id) const;
  static bool may_be_session(const Candidate& candidate);
  bool is_session(const Candidate& candidate) const;
  Result<Session> read(const Candidate& candidate) const;
  std::optional<Known> known(const Candidate& candidate) const;
  static Session described(const Candidate& candidate);
  bool is_news(const std::string& text) const;
  void forget(const std::string& id) const;
  void mend(const Session& session) const;
  std::vector<std::pair<Session, Candidate>> deletable(std::uint64_t now_ns) const;
  Result<void> erase(const Candidate& candidate);

  const std::filesystem::path folder_;
  const std::uint64_t max_bytes_;
  mutable FolderSizes sizes_;
  const std::string boot_;

  Mutex changes_;  // held while sessions are changed or deleted

  mutable Mutex lock_;  // guards the next two; not held while files are read
  // reading a session opens all its files, so the result is kept until the size or time of a file changes
  mutable std::map<std::string, std::pair<std::string, Result<Session>>> cache_;
  mutable std::set<std::string> reported_;  // sessions about whose fault a sentence was written

  mutable JobThread reader_;  // reads the sessions of these names; declared last, because it uses the others
};

}  // namespace robot::logging
