#include "robot/core/folder.h"

#include <dirent.h>
#include <fcntl.h>
#include <sys/stat.h>

#include <algorithm>
#include <cerrno>
#include <memory>
#include <optional>
#include <system_error>

#include "robot/core/clock.h"
#include "robot/core/files.h"

namespace robot {
namespace {

struct CloseFolder {
  void operator()(DIR* folder) const { ::closedir(folder); }
};

FolderEntry::Kind kind_of(mode_t mode) {
  if (S_ISREG(mode)) return FolderEntry::Kind::file;
  return S_ISDIR(mode) ? FolderEntry::Kind::folder : FolderEntry::Kind::other;
}

/// Returns nothing for an entry that was removed meanwhile.
std::optional<FolderEntry> entry_of(DIR* folder, const char* name) {
  struct stat status {};
  if (::fstatat(::dirfd(folder), name, &status, AT_SYMLINK_NOFOLLOW) != 0) return {};
  return FolderEntry{.name = name,
                     .kind = kind_of(status.st_mode),
                     .size_bytes = static_cast<std::uint64_t>(status.st_size),
                     .changed_ns = std::int64_t{status.st_mtim.tv_sec} * static_cast<std::int64_t>(kSecond) +
                                   std::int64_t{status.st_mtim.tv_nsec}};
}

}  // namespace

Result<std::vector<FolderEntry>> list_folder(const std::filesystem::path& path, std::size_t most) {
  const std::unique_ptr<DIR, CloseFolder> folder(::opendir(path.c_str()));
  if (!folder) return file_error("cannot read", path, errno);
  std::vector<FolderEntry> entries;
  while (true) {
    errno = 0;
    const dirent* const next = ::readdir(folder.get());
    if (!next && errno != 0) return file_error("cannot read", path, errno);
    if (!next) break;
    const std::string_view name = next->d_name;
    if (name == "." || name == "..") continue;
    if (entries.size() == most)
      return Error{"cannot read " + path.string() + ": expected at most " + std::to_string(most) +
                   " entries, got more"};
    if (auto entry = entry_of(folder.get(), next->d_name)) entries.push_back(std::move(*entry));
  }
  std::ranges::sort(entries, {}, &FolderEntry::name);
  return entries;
}

bool is_plain_file(const std::filesystem::path& path) {
  std::error_code ignored;
  return std::filesystem::is_regular_file(std::filesystem::symlink_status(path, ignored));
}

}  // namespace robot
