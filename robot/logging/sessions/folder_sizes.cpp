#include "robot/logging/sessions/folder_sizes.h"

#include <sys/stat.h>

#include <algorithm>
#include <mutex>
#include <utility>

#include "robot/core/clock.h"
#include "robot/core/folder.h"

namespace robot::logging {
namespace {

std::uint64_t changed_ns(const struct stat& status) {
  return static_cast<std::uint64_t>(status.st_mtim.tv_sec) * kSecond +
         static_cast<std::uint64_t>(status.st_mtim.tv_nsec);
}

/// Returns the time of the last change of `folder`, or 0 if it is no folder.
std::uint64_t folder_changed_ns(const std::filesystem::path& folder) {
  struct stat status {};
  return ::stat(folder.c_str(), &status) == 0 && S_ISDIR(status.st_mode) ? changed_ns(status) : 0;
}

/// Returns whether a change is at most `duration_ns` from now. A time far in the future comes from a clock that was wrong.
bool is_within(std::uint64_t duration_ns, std::uint64_t changed_ns, std::uint64_t now_ns) {
  return changed_ns + duration_ns > now_ns && changed_ns < now_ns + duration_ns;
}

}  // namespace

std::uint64_t FolderSizes::total(std::uint64_t now_ns) {
  const std::lock_guard guard(lock_);
  const std::uint64_t changed = folder_changed_ns(folder_);
  // two changes within a tick of the file system's clock have the same time
  if (looked_ns_ == 0 || changed != folder_changed_ns_ || is_within(kSettledNs, changed, now_ns) ||
      now_ns < looked_ns_ || now_ns >= looked_ns_ + kLookNs) {
    folder_changed_ns_ = changed;
    look(now_ns);
  }
  std::uint64_t bytes = 0;
  for (auto& [id, size] : sizes_) {
    if (is_within(kSettledNs, size.changed_ns, now_ns)) measure(folder_ / id, size);
    bytes += size.bytes;
  }
  return bytes;
}

std::uint64_t FolderSizes::measurements() const {
  const std::lock_guard guard(lock_);
  return measurements_;
}

/// Finds new, changed and removed sessions.
void FolderSizes::look(std::uint64_t now_ns) {
  looked_ns_ = now_ns;
  std::map<std::string, Size> there;
  const auto entries = list_folder(folder_);
  for (const FolderEntry& entry : entries ? *entries : std::vector<FolderEntry>()) {
    if (entry.kind != FolderEntry::Kind::folder) continue;
    const std::uint64_t changed = folder_changed_ns(folder_ / entry.name);
    const auto known = sizes_.find(entry.name);
    Size& size = there[entry.name];
    if (known != sizes_.end()) size = known->second;
    if (known == sizes_.end() || size.folder_changed_ns != changed || is_within(kWatchedNs, size.changed_ns, now_ns))
      measure(folder_ / entry.name, size);
  }
  sizes_ = std::move(there);
}

void FolderSizes::measure(const std::filesystem::path& session, Size& size) {
  ++measurements_;
  size = {.folder_changed_ns = folder_changed_ns(session)};
  size.changed_ns = size.folder_changed_ns;
  bool is_session = false;
  const auto entries = list_folder(session);
  for (const FolderEntry& entry : entries ? *entries : std::vector<FolderEntry>()) {
    if (entry.kind != FolderEntry::Kind::file) continue;
    size.bytes += entry.size_bytes;
    size.changed_ns =
        std::max(size.changed_ns, static_cast<std::uint64_t>(std::max<std::int64_t>(entry.changed_ns, 0)));
    is_session |= entry.name == "session.json";
  }
  if (!is_session) size.bytes = 0;
}

}  // namespace robot::logging
