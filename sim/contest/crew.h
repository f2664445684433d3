// Processes that play blocks of pairs. One that dies, whoever killed it, is replaced, and its block played anew.
#pragma once

#include <sys/types.h>

#include <chrono>
#include <cstdint>
#include <optional>
#include <vector>

#include "robot/core/files.h"
#include "robot/core/result.h"
#include "sim/contest/comparison.h"
#include "sim/contest/run_folder.h"

namespace sim::contest {

/// A block that was played.
struct PlayedBlock {
  std::int64_t number = 0;
  std::vector<compare::Pair> pairs;
  DecisionCost cost[2];  // of A, of B
};

/// Used by one thread of a process that has no other.
class Crew {
 public:
  using Clock = std::chrono::steady_clock;

  /// Nobody is hired before there is something to do. `comparison` outlives this.
  Crew(const Comparison& comparison, int jobs) : comparison_(comparison), workers_(static_cast<std::size_t>(jobs)) {}
  /// Whoever still plays is sent away.
  ~Crew();
  Crew(const Crew&) = delete;
  Crew& operator=(const Crew&) = delete;

  bool has_somebody_idle() const;
  /// To somebody who is idle.
  robot::Result<void> give(std::int64_t block);
  /// The next block that somebody has finished; nothing when the time is over. An Error where a game cannot be played.
  std::optional<robot::Result<PlayedBlock>> wait(Clock::time_point deadline);

 private:
  struct Worker {
    pid_t pid = -1;  // -1: not hired
    robot::FileDescriptor line;
    std::int64_t block = -1;  // -1: idle
    int deaths = 0;           // over this block
  };

  robot::Result<void> hire(Worker& worker);
  robot::Result<void> hand_out(Worker& worker);
  robot::Result<void> replace(Worker& worker);
  std::optional<robot::Result<PlayedBlock>> hear(Worker& worker);
  [[noreturn]] void work(int line) const;

  const Comparison& comparison_;
  std::vector<Worker> workers_;
};

}  // namespace sim::contest
