// Foresight's place on the robot: it hears questions, asks some of its own accord, and writes the answers to memory.
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

/// What people may change while it runs; read before each question.
struct AskingOptions {
  bool on = true;                 // the captain asks of its own accord
  double period = 10;             // [s] of game time, at most from one such question to the next
  std::uint32_t budget_ms = 500;  // for each
  double horizon = 30;            // [s]
  // what a change must gain is the same as in simulated games
  float switching_cost = sim::foresight::Terms().switching_cost;  // [goals]
  float sure = sim::foresight::Terms().sure;
};

/// A thread of its own: it waits for the object `what_if`, which a team's process writes, and looks ten times a second,
/// whatever is asked, at what the team plays and whether the captain has a reason to ask. Every answer becomes the object
/// `forecast`; what the team plays, chosen here or heard from the captain, is the object `strategy`, and how well forecasts
/// come true `forecast_score`.
///
/// Each new id in `what_if` is one question; while one runs and one waits, the next is answered at once by a refusal. The
/// captain asks one question at a time, which waits for who is before it, and the next place that gets free is its own.
class Advisor {
 public:
  /// It owns `foreseer`; all others outlive the advisor. `now_ns`: the time of what memory holds [ns since the epoch];
  /// both functions are called by any thread.
  Advisor(std::unique_ptr<Foreseer> foreseer, memory::Memory& memory, const memory::Channels& channels,
          std::string robot, std::function<std::uint64_t()> now_ns, std::function<AskingOptions()> options);
  ~Advisor();
  Advisor(const Advisor&) = delete;
  Advisor& operator=(const Advisor&) = delete;

  /// Asks and waits for the answer, which becomes the object `forecast` too. Any thread but the advisor's own.
  Result<pb::Forecast> ask(pb::WhatIf question);

  Foreseer& foreseer() { return *foreseer_; }

  /// What the team plays now: as this robot chose it, or heard that another did; first the first strategy.
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
  const std::vector<std::string> strategies_;  // its own; the last answers come while it ends
  memory::Memory& memory_;
  const memory::Channels& channels_;
  const std::string robot_;
  const std::function<std::uint64_t()> now_ns_;
  const std::function<AskingOptions()> options_;

  mutable Mutex lock_;
  Condition woken_;
  Following following_;
  std::string reason_;  // why this robot chose what is played; empty where another did
  int captain_ = 0;
  std::uint64_t written_ns_ = 0;  // when `strategy` was written last
  // that the scorer has not heard yet
  std::vector<bridge::Remembered<pb::Forecast>> unscored_;
  std::vector<bridge::Remembered<pb::Strategy>> played_;
  // of the advisor's own thread
  Scorer scorer_;
  std::optional<std::uint64_t> newest_id_;  // of the questions in memory
  bool captain_waits_ = false;              // it has a reason to ask, and found no place
  // of any thread
  std::deque<std::shared_ptr<const memory::Version>> heard_;  // questions that were not taken yet
  std::uint64_t missed_ = 0;                                  // that came faster than they could be taken
  std::atomic<bool> running_ = true;
  std::atomic<bool> captain_asks_ = false;  // its question runs or waits
  std::unique_ptr<Inbox> inbox_;
  std::thread thread_;
};

}  // namespace robot::foreseeing
