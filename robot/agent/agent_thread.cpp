#include "robot/agent/agent_thread.h"

#include <mutex>
#include <utility>

#include "robot/core/attempt.h"
#include "robot/core/report.h"
#include "robot/core/thread.h"

namespace robot::agent {

AgentThread::AgentThread(Agent agent, memory::Memory& memory, const memory::Channels& channels, std::string robot,
                         const Clock& clock)
    : agent_(std::move(agent)), memory_(memory), channels_(channels), robot_(std::move(robot)), clock_(clock) {}

Result<void> AgentThread::start() {
  return start_thread(thread_, "agent", [this] { run(); });
}

AgentThread::~AgentThread() {
  {
    const std::lock_guard guard(lock_);
    ends_ = true;
    changed_.notify_all();
  }
  if (thread_.joinable()) thread_.join();
}

void AgentThread::run() {
  name_thread("agent");
  std::uint64_t due_ns = monotonic_ns();
  const std::lock_guard guard(lock_);
  while (!ends_) {
    lock_.unlock();
    if (const Result<void> decided = attempt("a decision", [this] { decide(); }); !decided)
      report(Level::error, "agent", decided.error());
    lock_.lock();
    // an even rhythm; after a long delay it starts anew instead of catching up
    due_ns = std::max(due_ns + kPeriodNs, monotonic_ns() > 2 * kPeriodNs ? monotonic_ns() - 2 * kPeriodNs : 0);
    while (!ends_ && monotonic_ns() < due_ns) changed_.wait_until(lock_, due_ns);
  }
}

void AgentThread::decide() {
  const std::uint64_t now_ns = clock_.now_ns();
  if (const auto chosen = memory_.strategy.read(); chosen && chosen->value().chosen())
    agent_.follow({.strategy = static_cast<std::uint8_t>(chosen->value().number()),
                   .epoch = static_cast<std::uint8_t>(chosen->value().epoch())});

  Agent::Decision decision = agent_.decide(bridge::recollect(channels_, robot_, now_ns));
  memory_.motion_command.write(decision.command, now_ns);
  if (decision.trace) memory_.decision.write(*decision.trace, now_ns);
  if (decision.problem != problem_) {
    problem_ = std::move(decision.problem);
    if (problem_.empty())
      report(Level::info, "agent", "the behaviour decides");
    else
      report(Level::warning, "agent", "the robot stands: " + problem_);
  }
}

}  // namespace robot::agent
