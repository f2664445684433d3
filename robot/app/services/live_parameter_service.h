// Parameters that a team's own processes announce, in the table that people set.
#pragma once

#include <memory>
#include <string>

#include "robot/core/clock.h"
#include "robot/core/result.h"
#include "robot/memory/channels.h"
#include "robot/net/foxglove/parameters.h"

namespace robot::app {

/// The link between the objects "live_parameters/PROCESS" of a robot and the table of parameters, in which they have the
/// names "PROCESS.NAME". The object "live_parameters" shows the values that hold to processes and viewers.
/// proto/foresight/live_parameters.proto documents both objects and all limits.
///
/// A value that was set differs from the initial one. It is not lost while the runtime or the process lives. The runtime
/// keeps it for a process that comes back, and a process announces it to a runtime that has started again. If both hold
/// such a value, the runtime's is valid. Nobody sets parameters of a process that has gone.
class LiveParameterService {
 public:
  static constexpr std::size_t kMaxParameters = 256;  // of all processes

  /// Adds the channel "/<robot>/live_parameters" and follows the channels of processes. `clock`, `parameters` and
  /// `channels` outlive this. Returns an Error if the topic is taken.
  static Result<std::unique_ptr<LiveParameterService>> open(net::Parameters& parameters, const std::string& robot,
                                                            memory::Channels& channels, const Clock& clock);
  ~LiveParameterService();

  /// Marks the parameters of the process that wrote `topic` as gone. Other topics have no effect. Any thread.
  void ended(const std::string& topic);

 private:
  class Core;

  LiveParameterService(std::shared_ptr<Core> core, memory::Channels& channels);

  const std::shared_ptr<Core> core_;
  memory::Channels& channels_;
  memory::Channels::WatcherId watcher_ = 0;
};

}  // namespace robot::app
