// The store of all sessions in one log folder.
#pragma once

#include <cstdint>
#include <filesystem>
#include <map>
#include <string>
#include <vector>

#include "robot/core/lock.h"
#include "robot/core/result.h"
#include "robot/logging/sessions/folder_sizes.h"
#include "robot/logging/sessions/session.h"

namespace robot::logging {

/// The sessions of a folder: it lists, keeps and deletes them. Any thread.
class SessionStore {
 public:
  /// make_room() never deletes a session younger than this [ns].
  static constexpr std::uint64_t kSafeAgeNs = 24ull * 3600 * 1'000'000'000;

  /// `folder` may be missing; recording creates it. All sessions together may take at most `max_bytes`.
  SessionStore(std::filesystem::path folder, std::uint64_t max_bytes)
      : folder_(std::move(folder)), max_bytes_(max_bytes), sizes_(folder_) {}

  const std::filesystem::path& folder() const { return folder_; }
  std::uint64_t max_bytes() const { return max_bytes_; }

  /// Returns all sessions, the newest first. Leaves out folders without a session.
  std::vector<Session> list() const;

  /// Returns the session `id`, or an Error if there is none. Refuses an id that contains a path.
  Result<Session> find(std::string_view id) const;

  /// Sets whether the session is kept, so that make_room() never deletes it.
  Result<void> keep(std::string_view id, bool keep);

  /// Deletes a session of any age. Returns an Error for one that is kept or being written.
  Result<void> remove(std::string_view id);

  /// Sets the session that is being written now; empty for none.
  void set_recording(std::string id);

  /// Deletes the oldest sessions until `bytes` of the cap are free. Never deletes a kept session, one of the last 24 h
  /// before `now_ns`, or the one that is being written. Returns the ids of the deleted sessions.
  std::vector<std::string> make_room(std::uint64_t bytes, std::uint64_t now_ns);

  /// Returns how much make_room() could free at `now_ns` [bytes].
  std::uint64_t deletable_bytes(std::uint64_t now_ns) const;

  /// Returns the free space on the folder's disk [bytes], or 0 if it is unknown.
  std::uint64_t disk_free_bytes() const;

  /// Returns the size of all sessions [bytes]. Never waits for another function, and costs nothing while all sessions
  /// stay the same.
  std::uint64_t size_bytes() const;

 private:
  Result<Session> read(const std::filesystem::path& folder) const;
  bool deletable(const Session& session, std::uint64_t now_ns) const;

  const std::filesystem::path folder_;
  const std::uint64_t max_bytes_;
  mutable FolderSizes sizes_;

  mutable Mutex lock_;
  std::string recording_;
  // reading a session opens all its files, so the result is kept until the size or time of a file changes
  mutable std::map<std::string, std::pair<std::string, Session>> cache_;
};

}  // namespace robot::logging
