// The thread that plays the futures of a question, out of the way of everybody else.
#pragma once

#include <atomic>
#include <cstdint>
#include <memory>
#include <thread>
#include <vector>

#include "robot/foresight/mailbox.h"
#include "sim/foresight/race.h"
#include "sim/io/playbook.h"

namespace robot::foreseeing {

/// What one question's futures are played from.
struct Futures {
  std::shared_ptr<const sim::io::Playbook> playbook;
  std::vector<int> strategies;  // of the playbook
  sim::foresight::Situation situation;
  sim::foresight::Question question;
  sim::RandomKey key;
};

/// Which share of a busy processor the futures get.
enum class Share : std::uint8_t {
  left_over,   // idle priority: what nobody else wants, beside a robot that plays
  background,  // nice 10: a twentieth and more, where no robot waits
};

/// What they have come to.
struct Progress {
  std::uint64_t race = 0;  // which `begin` they are of
  sim::foresight::RolloutStatistics tally;
  std::uint64_t computed_ns = 0;  // of processor time
};

/// On a busy processor a thread that takes what is left over may sleep for a second wherever it is. So it shares no lock
/// with anybody, and nothing here waits for it but the destructor.
///
/// All functions from one thread.
class Rollouts {
 public:
  explicit Rollouts(Share share);
  ~Rollouts();
  Rollouts(const Rollouts&) = delete;
  Rollouts& operator=(const Rollouts&) = delete;

  /// Plays `futures` from now on, in place of what it played, until monotonic_ns() is `deadline_ns` or `end`.
  void begin(Futures futures, std::uint64_t deadline_ns);

  /// As of the last whole stripe since `begin`; empty before there is one.
  Progress progress();

  /// Plays nothing any more.
  void end();

 private:
  struct Race {
    std::uint64_t number = 0;
    Futures futures;
    std::uint64_t began_ns = 0, deadline_ns = 0;  // [monotonic]
    std::atomic<bool> over = false;               // it is to end
    std::atomic<bool> let_go = false;             // the thread of the rollouts does not look at it any more
  };

  void run(Share share);
  void play(const Race& race);
  void wake();

  std::vector<std::unique_ptr<Race>> races_;  // the last one, and those that are not let go yet
  std::uint64_t number_ = 0;
  std::atomic<Race*> offered_ = nullptr;  // to be taken by the thread of the rollouts
  std::atomic<std::uint32_t> wakes_ = 0;
  std::atomic<bool> running_ = true;
  Mailbox<Progress> mailbox_;
  std::thread thread_;
};

}  // namespace robot::foreseeing
