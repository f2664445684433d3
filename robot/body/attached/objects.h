// Channels of the memory objects that a team's processes name.
#pragma once

#include <memory>
#include <set>
#include <string>
#include <string_view>

#include "robot/core/clock.h"
#include "robot/core/result.h"
#include "robot/memory/channels.h"

namespace robot::body {

/// A finder of channels for announced objects. It creates missing channels, of any type. Used by one thread.
class Objects {
 public:
  /// Most channels that are created for objects unknown to this runtime. Channels are never removed.
  static constexpr int kMaxMade = 256;

  /// `robot` is this robot, such as "14/2". `own` are objects that only the runtime writes, such as "runtime". Processes
  /// write only topics that begin with `written_below`; empty: any. `channels` and `clock` outlive this.
  Objects(std::string robot, std::set<std::string> own, std::string written_below, memory::Channels& channels,
          const Clock& clock);

  /// Returns the topic of an object: "ball" becomes "/14/2/ball" of this robot, and a name that starts with '/' is a
  /// topic already. Returns an Error if the result is no valid topic.
  Result<std::string> topic_of(std::string_view name) const;

  /// Returns the channel for `announced`, named as above. Returns an Error that names the part that does not fit.
  Result<std::shared_ptr<memory::Channel>> channel_of(memory::ChannelInfo announced);

 private:
  Result<void> complete(memory::ChannelInfo& announced) const;
  Result<std::shared_ptr<memory::Channel>> make(memory::ChannelInfo info);

  const std::string robot_;
  const std::set<std::string> own_;
  const std::string written_below_;
  memory::Channels& channels_;
  const Clock& clock_;
  int made_ = 0;
};

}  // namespace robot::body
