// The live robots of a process of the lab: each is read over one connection.
#pragma once

#include <filesystem>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "proto/foresight/runtime.pb.h"
#include "robot/app/robot_name.h"
#include "robot/core/lock.h"
#include "robot/core/result.h"
#include "robot/lab/relay/robot_link.h"
#include "robot/memory/memory_object.h"

namespace robot::app {

/// The links to several robots. Used by one thread, unless a function says otherwise.
class RelayedRobots {
 public:
  /// Finds the robots by their addresses, or by names of the robots file (empty: the default one), and asks each for its
  /// name. Waits for 2 s at most. Returns an Error for a word that is neither.
  static Result<std::unique_ptr<RelayedRobots>> find(const std::vector<std::string>& words,
                                                     const std::filesystem::path& robots_file);

  /// Returns the name of the first robot that answered. Session and page get this name.
  RobotName first() const;

  /// Begins to carry the robots' messages into `channels`, with these options for each robot. Each measurement of a robot's
  /// clock is written to `clock_samples`. Called once. All arguments outlive this.
  Result<void> connect(const lab::LinkOptions& options, memory::Channels& channels, const Clock& clock,
                       memory::MemoryObject<foresight::ClockSample>& clock_samples);

  /// Adds the state of each link. Any thread.
  void describe(foresight::RuntimeStatistics& statistics) const;

  /// Ends all connections.
  void stop();

 private:
  RelayedRobots() = default;

  std::vector<lab::RobotAddress> robots_;
  std::vector<std::optional<RobotName>> names_;  // of those that answered
  lab::TopicClaims claims_;
  mutable Mutex lock_;  // guards the links
  std::vector<std::unique_ptr<lab::RobotLink>> links_;
};

}  // namespace robot::app
