// The last minutes of a process's objects, for a viewer that comes late.
#pragma once

#include <cstdint>
#include <memory>
#include <span>
#include <string>
#include <thread>
#include <vector>

#include "robot/core/lock.h"
#include "robot/core/report.h"
#include "robot/core/result.h"
#include "robot/logging/recent/recent_file.h"
#include "robot/logging/streams/carrier.h"
#include "robot/memory/channels.h"

namespace robot::logging {

/// The bounds of the past.
struct RecentPastLimits {
  RecentLimits file;
  std::size_t message_bytes = 16 * 1024;  // larger messages are left out
  std::size_t queue_bytes = 256 * 1024;   // of the messages of a channel that wait to be carried
};

/// Room for ten robots, and for a game that is simulated at 100 times the speed of time.
inline constexpr RecentPastLimits kRecentPastOfTeams{.file = {.bytes = 60'000'000}, .queue_bytes = 1024 * 1024};

/// A thread that carries the versions of all channels into a RecentFile, five times a second. Channels of camera images
/// are left out. While the processor is too busy to carry them, the oldest versions of a full queue are left out and
/// counted, and a warning says so. If the system refuses the thread, there is no past, and a report says so. Any thread.
class RecentPast {
 public:
  /// `channels` outlives it.
  explicit RecentPast(memory::Channels& channels, const RecentPastLimits& limits = {});
  ~RecentPast();
  RecentPast(const RecentPast&) = delete;
  RecentPast& operator=(const RecentPast&) = delete;

  /// Returns the messages of the last minutes, up to this call, as one MCAP file; with `topics`, only those of them.
  Result<std::shared_ptr<const ByteSource>> file(std::span<const std::string> topics = {});

  /// Returns the number of versions that were left out because a queue was full.
  std::uint64_t dropped() const;

 private:
  class Provider;

  void add(const std::shared_ptr<memory::Channel>& channel);
  void carry();
  void warn_of_drops();
  void run();

  memory::Channels& channels_;
  const RecentPastLimits limits_;
  memory::Channels::WatcherId watcher_ = 0;

  Mutex carrying_;  // guards the file and the calls of the carriers
  RecentFile file_;

  mutable Mutex lock_;  // guards the rest; never held while anything is carried
  Condition changed_;
  std::vector<std::shared_ptr<Carrier>> carriers_;
  bool ended_ = false;

  Throttle warnings_;  // these two are of the thread
  std::uint64_t warned_of_ = 0;
  std::thread thread_;  // declared last, because it uses the others
};

}  // namespace robot::logging
