// The thread of a robot's agent.
#pragma once

#include <string>
#include <thread>

#include "robot/agent/agent.h"
#include "robot/core/clock.h"
#include "robot/core/lock.h"
#include "robot/memory/channels.h"
#include "robot/memory/memory.h"

namespace robot::agent {

/// Decides 30 times a second and writes `motion_command` and `decision`, with the capture time of the moment. It never
/// waits for readers, loggers or viewers. A reason why the robot only stands is reported when it changes.
class AgentThread {
 public:
  static constexpr std::uint64_t kPeriodNs = kSecond / 30;

  /// `channels` hold the objects of `memory`, among others; all references outlive the thread.
  AgentThread(Agent agent, memory::Memory& memory, const memory::Channels& channels, std::string robot,
              const Clock& clock);

  /// Starts the thread, once. Returns an Error if the system allows no more threads.
  Result<void> start();

  /// Ends the thread.
  ~AgentThread();
  AgentThread(const AgentThread&) = delete;
  AgentThread& operator=(const AgentThread&) = delete;

 private:
  void run();
  void decide();

  Agent agent_;
  memory::Memory& memory_;
  const memory::Channels& channels_;
  const std::string robot_;  // "14/2"
  const Clock& clock_;
  std::string problem_;  // the last one

  Mutex lock_;  // guards ends_
  Condition changed_;
  bool ends_ = false;
  std::thread thread_;  // last: it uses all the others
};

}  // namespace robot::agent
