// The checksums of the files of sessions.
#pragma once

#include <sys/types.h>

#include <cstdint>
#include <filesystem>
#include <functional>
#include <map>
#include <optional>
#include <string>
#include <tuple>
#include <vector>

#include "robot/core/lock.h"
#include "robot/core/result.h"

namespace robot::logging {

/// A file of a session on the disk.
struct SessionFile {
  std::string name;  // "14.2.ball.mcap", "session.json"
  std::uint64_t size_bytes = 0;
  std::uint32_t crc32 = 0;  // of all its bytes
};

/// The checksums that were computed, kept while a file stays the same: device, inode, size and time of its last change.
/// Any thread.
class Checksums {
 public:
  /// Returns all ordinary files in `folder`, by name. Leaves out hidden files, links, pipes and subfolders. Reads every
  /// byte of a file whose checksum is not kept. Returns an Error soon after `cancelled` becomes true; files that are done
  /// are kept.
  Result<std::vector<SessionFile>> of_folder(const std::filesystem::path& folder,
                                             const std::function<bool()>& cancelled = {});

  /// Returns how many bytes were read so far.
  std::uint64_t bytes_read() const;

 private:
  // device, inode, size [bytes], time of the last change [ns since the epoch]
  using Identity = std::tuple<dev_t, ino_t, std::uint64_t, std::uint64_t>;

  static std::optional<Identity> identity_of(const std::filesystem::path& path);
  Result<std::uint32_t> read(const std::filesystem::path& path, const std::function<bool()>& cancelled);
  std::optional<std::uint32_t> kept(const Identity& identity) const;
  void keep(const Identity& identity, std::uint32_t crc32);

  mutable Mutex lock_;
  std::map<Identity, std::uint32_t> kept_;
  std::uint64_t bytes_read_ = 0;
};

}  // namespace robot::logging
