// Which memory object a team's process means.
#pragma once

#include <memory>
#include <set>
#include <string>
#include <string_view>

#include "robot/core/clock.h"
#include "robot/core/result.h"
#include "robot/memory/channels.h"

namespace robot::body {

/// Finds the channel of what is announced; makes it when nobody has it yet, whatever its type. Used by one thread.
class Objects {
 public:
  /// So many channels are made for objects that this runtime does not know; channels stay for good.
  static constexpr int kMaxMade = 256;

  /// `robot` is ours, "14/2"; `own` are objects that only the runtime writes, such as "runtime". `channels` and `clock`
  /// outlive this.
  Objects(std::string robot, std::set<std::string> own, memory::Channels& channels, const Clock& clock);

  /// "ball" is an object of this robot, "/14/2/ball"; what starts with '/' is a topic as it stands. An Error if that is
  /// no name for a topic.
  Result<std::string> topic_of(std::string_view name) const;

  /// The channel that `announced`, named as above, writes to. An Error says what of it does not fit.
  Result<std::shared_ptr<memory::Channel>> channel_of(memory::ChannelInfo announced);

 private:
  Result<void> complete(memory::ChannelInfo& announced) const;
  Result<std::shared_ptr<memory::Channel>> make(memory::ChannelInfo info);

  const std::string robot_;
  const std::set<std::string> own_;
  memory::Channels& channels_;
  const Clock& clock_;
  int made_ = 0;
};

}  // namespace robot::body
