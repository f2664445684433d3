// All channels of one process: those of the typed memory and those met at run time.
#pragma once

#include <functional>
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

  /// Calls `watcher` for every channel listed now and for each one added later, by the thread that adds it.
  /// Watchers stay as long as the list; they must not add channels.
  void watch(std::function<void(const std::shared_ptr<Channel>&)> watcher);

 private:
  mutable Mutex lock_;
  std::vector<std::shared_ptr<Channel>> channels_;
  std::vector<std::function<void(const std::shared_ptr<Channel>&)>> watchers_;
};

}  // namespace robot::memory
