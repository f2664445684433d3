// All channels of one process: those of the typed memory and those met at run time.
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

/// The list that loggers and the server go by. Channels are only ever added, each topic once. Any thread.
class Channels {
 public:
  /// Lists `channel` and tells the watchers; an Error if its topic is listed already.
  Result<void> add(std::shared_ptr<Channel> channel);

  /// All channels, in the order in which they were added.
  std::vector<std::shared_ptr<Channel>> all() const;

  /// The channel of `topic`, or null.
  std::shared_ptr<Channel> find(std::string_view topic) const;

  using WatcherId = std::uint64_t;

  /// Calls `watcher` for every channel listed now and for each one added later, by the thread that adds it.
  /// A watcher must neither add channels nor watch.
  WatcherId watch(std::function<void(const std::shared_ptr<Channel>&)> watcher);

  /// After return that watcher is not being called and will not be called again.
  void unwatch(WatcherId watcher);

 private:
  Mutex adding_;  // held while watchers are called; guards the watchers
  std::map<WatcherId, std::function<void(const std::shared_ptr<Channel>&)>> watchers_;
  WatcherId last_watcher_ = 0;

  mutable Mutex lock_;  // guards the list, which watchers may read
  std::vector<std::shared_ptr<Channel>> channels_;
};

}  // namespace robot::memory
