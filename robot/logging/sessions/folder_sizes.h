// The sizes of all sessions in a log folder.
#pragma once

#include <cstdint>
#include <filesystem>
#include <map>
#include <string>

#include "robot/core/lock.h"

namespace robot::logging {

/// The sizes of the sessions in a folder. A session that changed in the last kSettledNs is measured at each call. Others
/// are measured at a look at all folders, if the folder changed, or one of its files within the last hour. So thousands of
/// old sessions cost nothing. Any thread.
class FolderSizes {
 public:
  static constexpr std::uint64_t kSettledNs = 10'000'000'000;

  /// Time between two looks [ns]. A change of the log folder makes an earlier one.
  static constexpr std::uint64_t kLookNs = 60'000'000'000, kWatchedNs = 3600ull * 1'000'000'000;

  explicit FolderSizes(std::filesystem::path folder) : folder_(std::move(folder)) {}

  /// Returns the size of all sessions [bytes]. `now_ns` is the system clock, which files have their times from.
  std::uint64_t total(std::uint64_t now_ns);

  /// Returns how often the files of a session were looked at.
  std::uint64_t measurements() const;

 private:
  struct Size {
    std::uint64_t folder_changed_ns = 0;  // before it was measured
    std::uint64_t changed_ns = 0;         // the newest change of the folder and its files
    std::uint64_t bytes = 0;              // 0 if it is no session
  };

  void look(std::uint64_t now_ns);
  void measure(const std::filesystem::path& session, Size& size);

  const std::filesystem::path folder_;

  mutable Mutex lock_;  // guards the rest
  std::uint64_t folder_changed_ns_ = 0, looked_ns_ = 0;
  std::map<std::string, Size> sizes_;  // by the name of the session's folder
  std::uint64_t measurements_ = 0;
};

}  // namespace robot::logging
