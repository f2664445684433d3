// All sessions in one log folder.
#pragma once

#include <cstdint>
#include <filesystem>
#include <map>
#include <string>
#include <vector>

#include "robot/core/lock.h"
#include "robot/core/result.h"
#include "robot/logging/sessions/session.h"

namespace robot::logging {

/// Lists, keeps and deletes sessions. Any thread.
class SessionStore {
 public:
  /// A session younger than this is never deleted to make room [ns].
  static constexpr std::uint64_t kSafeAgeNs = 24ull * 3600 * 1'000'000'000;

  /// `folder` is made when it is missing. All sessions together are to take at most `max_bytes`.
  SessionStore(std::filesystem::path folder, std::uint64_t max_bytes)
      : folder_(std::move(folder)), max_bytes_(max_bytes) {}

  const std::filesystem::path& folder() const { return folder_; }
  std::uint64_t max_bytes() const { return max_bytes_; }

  /// All sessions, the newest first. A folder that is none is left out.
  std::vector<Session> list() const;

  /// The session called `id`; an Error if there is none. An id with a path in it is refused.
  Result<Session> find(std::string_view id) const;

  /// Says whether the session may be deleted to make room.
  Result<void> keep(std::string_view id, bool keep);

  /// Deletes a session, the last 24 h or not; an Error for one that is kept or being written.
  Result<void> remove(std::string_view id);

  /// Names the session that is being written now, or none.
  void set_recording(std::string id);

  /// Deletes the oldest sessions until all of them leave `bytes` of the cap: never one of the last 24 h before `now_ns`,
  /// a kept one or the one being written. Returns the ids of what went.
  std::vector<std::string> make_room(std::uint64_t bytes, std::uint64_t now_ns);

  /// What make_room() could free at `now_ns` [bytes].
  std::uint64_t deletable_bytes(std::uint64_t now_ns) const;

  /// Free space of the disk the folder is on [bytes]; 0 if that cannot be told.
  std::uint64_t disk_free_bytes() const;

  /// What all sessions take [bytes].
  std::uint64_t size_bytes() const;

 private:
  Result<Session> read(const std::filesystem::path& folder) const;
  bool deletable(const Session& session, std::uint64_t now_ns) const;

  const std::filesystem::path folder_;
  const std::uint64_t max_bytes_;

  mutable Mutex lock_;
  std::string recording_;
  // reading a session opens all its files: kept until a file's size or time changes
  mutable std::map<std::string, std::pair<std::string, Session>> cache_;
};

}  // namespace robot::logging
