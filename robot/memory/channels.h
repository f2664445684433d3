// All channels of one process: those of the typed memory and those that appear at run time.
#pragma once

#include <cstdint>
#include <functional>
#include <map>
#include <memory>
#include <string>
#include <string_view>
#include <vector>

#include "robot/memory/channel.h"

namespace robot::memory {

/// The list of channels, used by the loggers and the server. Channels are added and never removed. Any thread.
class Channels {
 public:
  /// Adds `channel` and calls the watchers. Returns an Error if a channel with its topic is in the list already.
  Result<void> add(std::shared_ptr<Channel> channel);

  /// Returns all channels in the order in which they were added.
  std::vector<std::shared_ptr<Channel>> all() const;

  /// Returns the channel with `topic`, or null.
  std::shared_ptr<Channel> find(std::string_view topic) const;

  using WatcherId = std::uint64_t;

  /// Calls `watcher` for every channel in the list, and for each later one in the thread that adds it.
  /// A watcher must neither add channels nor call watch().
  WatcherId watch(std::function<void(const std::shared_ptr<Channel>&)> watcher);

  /// Removes a watcher. When it returns, the watcher is not running and will not be called again.
  void unwatch(WatcherId watcher);

 private:
  Mutex adding_;  // held while watchers are called; guards the watchers
  std::map<WatcherId, std::function<void(const std::shared_ptr<Channel>&)>> watchers_;
  WatcherId last_watcher_ = 0;

  mutable Mutex lock_;  // guards the list, which watchers may read
  std::vector<std::shared_ptr<Channel>> channels_;
};

}  // namespace robot::memory
