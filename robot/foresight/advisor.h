// Foresight on the robot: takes questions from memory, asks some itself as the captain,
// and writes the answers to memory.
#pragma once

#include <atomic>
#include <cstdint>
#include <deque>
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <thread>
#include <vector>

#include "robot/core/lock.h"
#include "robot/foresight/following.h"
#include "robot/foresight/foreseer.h"
#include "robot/foresight/scorer.h"
#include "robot/foresight/triggers.h"
#include "robot/memory/memory.h"
#include "sim/foresight/chooser.h"

namespace robot::foreseeing {

/// The parameters that people may change at runtime. They are read before each question.
struct AskingOptions {
  bool on = true;                 // the captain asks by itself
  double period = 10;             // [s] of game time, longest time between two such questions
  std::uint32_t budget_ms = 500;  // for each question
  double horizon = 30;            // [s]
  // the necessary gain of a change, as in simulated games
  float switching_cost = sim::foresight::Terms().switching_cost;  // [goals]
  float sure = sim::foresight::Terms().sure;
};

/// A thread of its own. It waits for the object `what_if`, which a team's process writes. Ten times a second it checks
/// the team's strategy and whether the captain has a reason to ask. It writes three objects: each answer as `forecast`,
/// the strategy that the captain chose as `strategy`, and the quality of past forecasts as `forecast_score`.
///
/// Each new id in `what_if` is one question. While one question runs and one waits, the next is refused at once. The
/// captain asks one question at a time and gets the next free place.
class Advisor {
 public:
  /// Takes over `foreseer`; all others outlive the advisor. `now_ns` returns the time of the data in memory [ns since
  /// the epoch]. Both functions are called by any thread.
  Advisor(std::unique_ptr<Foreseer> foreseer, memory::Memory& memory, const memory::Channels& channels,
          std::string robot, std::function<std::uint64_t()> now_ns, std::function<AskingOptions()> options);

  /// Starts the thread, once. Returns an Error if the system allows no more threads.
  Result<void> start();

  ~Advisor();
  Advisor(const Advisor&) = delete;
  Advisor& operator=(const Advisor&) = delete;

  /// Asks and waits for the answer, which is also written as `forecast`. Any thread except the advisor's own.
  Result<pb::Forecast> ask(pb::WhatIf question);

  Foreseer& foreseer() { return *foreseer_; }

  /// Returns the team's strategy: this robot's own choice or the captain's. It is the first strategy until then.
  std::string strategy() const;

 private:
  class Inbox;

  void run();
  std::shared_ptr<const memory::Version> next_heard(std::uint64_t until_ns);
  void take_question(const memory::Version& version);
  void look(Triggers& triggers);
  void ask_of_own_accord(const bridge::Recollection& now, const AskingOptions& options, Triggers& triggers);
  void keep(const pb::Forecast& forecast);
  void decide(const pb::Forecast& forecast, int leader);
  bool leads(int player) const;
  void follow(std::uint64_t now_ns, const AskingOptions& options);
  void score(std::uint64_t now_ns);
  void write_strategy(std::uint64_t now_ns);

  std::unique_ptr<Foreseer> foreseer_;
  const std::vector<std::string> strategies_;  // a copy: the last answers come during the destruction
  memory::Memory& memory_;
  const memory::Channels& channels_;
  const std::string robot_;
  const std::function<std::uint64_t()> now_ns_;
  const std::function<AskingOptions()> options_;

  mutable Mutex lock_;
  Condition woken_;
  Following following_;
  std::string reason_;  // of this robot's choice; empty if another robot chose
  int captain_ = 0;
  std::uint64_t written_ns_ = 0;  // time of the last `strategy`
  // not yet passed to the scorer
  std::vector<bridge::Remembered<pb::Forecast>> unscored_;
  std::vector<bridge::Remembered<pb::Strategy>> played_;
  // used by the advisor's own thread
  Scorer scorer_;
  std::optional<std::uint64_t> newest_id_;  // of the questions in memory
  bool captain_waits_ = false;              // it has a reason to ask, but no place was free
  // used by any thread
  std::deque<std::shared_ptr<const memory::Version>> heard_;  // questions that are not taken yet
  std::uint64_t missed_ = 0;                                  // questions lost because they came too fast
  std::atomic<bool> running_ = true;
  std::atomic<bool> captain_asks_ = false;  // its question runs or waits
  std::unique_ptr<Inbox> inbox_;
  std::thread thread_;
};

}  // namespace robot::foreseeing
