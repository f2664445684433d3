// The entries of a folder.
#pragma once

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <string>
#include <vector>

#include "robot/core/result.h"

namespace robot {

/// An entry of a folder. A symbolic link, a named pipe and a device are `other`.
struct FolderEntry {
  enum class Kind { file, folder, other };

  std::string name;
  Kind kind = Kind::other;
  std::uint64_t size_bytes = 0;
  std::int64_t changed_ns = 0;  // [ns since the epoch] of the last change of its bytes, by the system clock
};

/// Returns the entries of the folder at `path`, by name. Opens none of them, so that a named pipe cannot block, and
/// follows no symbolic link among them. Returns an Error if the folder cannot be read or has more than `most` entries.
/// Does not throw.
Result<std::vector<FolderEntry>> list_folder(const std::filesystem::path& path, std::size_t most = 100'000);

/// Returns whether a file lies at `path`, and no folder, symbolic link, named pipe or device. Does not throw.
bool is_plain_file(const std::filesystem::path& path);

}  // namespace robot
