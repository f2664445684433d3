// Worker processes that play blocks of pairs. A worker that dies is replaced, and the new one plays its block again.
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

/// A block of played pairs.
struct PlayedBlock {
  std::int64_t number = 0;
  std::vector<compare::Pair> pairs;
  DecisionCost cost[2];  // of A, of B
};

/// The worker processes. Used by one thread, in a process without other threads, because it forks.
class Crew {
 public:
  using Clock = std::chrono::steady_clock;

  /// Starts no process before the first block. `comparison` outlives this.
  Crew(const Comparison& comparison, int jobs) : comparison_(comparison), workers_(static_cast<std::size_t>(jobs)) {}
  /// Kills the workers that still play.
  ~Crew();
  Crew(const Crew&) = delete;
  Crew& operator=(const Crew&) = delete;

  bool has_somebody_idle() const;
  /// Gives a block to an idle worker; there must be one.
  robot::Result<void> give(std::int64_t block);
  /// Waits for the next finished block. Returns nothing after `deadline`, and an Error if a game cannot be played.
  std::optional<robot::Result<PlayedBlock>> wait(Clock::time_point deadline);

 private:
  struct Worker {
    pid_t pid = -1;  // -1: not started
    robot::FileDescriptor line;
    std::int64_t block = -1;  // -1: idle
    int deaths = 0;           // during this block
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
