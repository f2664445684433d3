// The thread that plays the futures of a question, at the lowest priority.
#pragma once

#include <atomic>
#include <cstdint>
#include <memory>
#include <thread>
#include <vector>

#include "robot/core/result.h"
#include "robot/foresight/mailbox.h"
#include "sim/foresight/race.h"
#include "sim/io/playbook.h"

namespace robot::foreseeing {

/// The inputs of the futures of one question.
struct Futures {
  std::shared_ptr<const sim::io::Playbook> playbook;
  std::vector<int> strategies;  // of the playbook
  sim::foresight::Situation situation;
  sim::foresight::Question question;
  sim::RandomKey key;
};

/// The share of a busy processor for the futures.
enum class Share : std::uint8_t {
  left_over,   // idle priority: unused time only, beside a robot that plays
  background,  // nice 10: at least a twentieth, where no robot waits
};

/// The results of the futures so far.
struct Progress {
  std::uint64_t race = 0;  // number of their `begin`
  sim::foresight::RolloutStatistics statistics;
  std::uint64_t computed_ns = 0;  // of processor time
};

/// On a busy processor a thread of idle priority may sleep for a second at any place. So it shares no lock with other
/// threads, and only the destructor waits for it.
///
/// All functions from one thread.
class Rollouts {
 public:
  explicit Rollouts(Share share) : share_(share) {}
  ~Rollouts();
  Rollouts(const Rollouts&) = delete;
  Rollouts& operator=(const Rollouts&) = delete;

  /// Starts the thread, once. Returns an Error if the system allows no more threads.
  Result<void> start();

  /// Plays `futures` instead of the previous ones, until monotonic_ns() reaches `deadline_ns` or end() is called.
  void begin(Futures futures, std::uint64_t deadline_ns);

  /// Returns the results at the last complete stripe since `begin`, empty before the first.
  Progress progress();

  /// Stops playing.
  void end();

 private:
  struct Race {
    std::uint64_t number = 0;
    Futures futures;
    std::uint64_t began_ns = 0, deadline_ns = 0;  // [monotonic]
    std::atomic<bool> over = false;               // it must end
    std::atomic<bool> let_go = false;             // the rollouts' thread no longer uses it
  };

  void run();
  void play(const Race& race);
  void wake();

  const Share share_;
  std::vector<std::unique_ptr<Race>> races_;  // the last one, and those still in use
  std::uint64_t number_ = 0;
  std::atomic<Race*> offered_ = nullptr;  // for the rollouts' thread
  std::atomic<std::uint32_t> wakes_ = 0;
  std::atomic<bool> running_ = true;
  Mailbox<Progress> mailbox_;
  std::thread thread_;
};

}  // namespace robot::foreseeing
