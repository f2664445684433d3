// The folder of a session that this process writes.
#pragma once

#include <cstdint>
#include <filesystem>
#include <string>

#include "robot/core/files.h"
#include "robot/core/result.h"

namespace robot::logging {

/// The name of the lock file in the folder of a session that is being written.
inline constexpr const char* kLockFile = ".lock";

/// A folder with a lock file that this process holds (flock). The death of the process releases it. The destructor
/// releases it and removes the lock file; the folder stays.
class OwnedFolder {
 public:
  /// Makes a new folder `name` in `parent`, which is made too if it is missing. Takes `name_2`, `name_3` … if the name
  /// is in use.
  static Result<OwnedFolder> make(const std::filesystem::path& parent, const std::string& name);

  /// Owns the folder at `path`. Returns an Error if another owner holds it.
  static Result<OwnedFolder> own(const std::filesystem::path& path);

  OwnedFolder(OwnedFolder&&) = default;
  OwnedFolder& operator=(OwnedFolder&&) = delete;
  ~OwnedFolder();

  const std::filesystem::path& path() const { return path_; }
  std::string name() const { return path_.filename().string(); }

  /// Returns whether the path still names this folder: it was neither deleted nor replaced nor moved.
  bool in_place() const { return is_at(path_); }

  /// Returns the path that names this folder now, also after a move, or an empty one if the folder was deleted.
  std::filesystem::path present_path() const;

  /// Gives up the ownership and removes the lock file. The folder is still known, so that present_path() finds it.
  void release();

  /// Returns the identity of the file `name` in this folder, also after a move of the folder. Returns 0 if there is no
  /// such file.
  std::uint64_t identity_of(const std::string& name) const;

  /// Removes the folder again. For a session that could not begin; the folder may contain only the lock file.
  void discard();

 private:
  OwnedFolder(std::filesystem::path path, FileDescriptor folder, FileDescriptor lock)
      : path_(std::move(path)), folder_(std::move(folder)), lock_(std::move(lock)) {}

  bool is_at(const std::filesystem::path& path) const;

  std::filesystem::path path_;
  FileDescriptor folder_, lock_;
};

/// Returns whether a living process owns the folder at `path`: this one, too.
bool is_owned(const std::filesystem::path& path);

}  // namespace robot::logging
