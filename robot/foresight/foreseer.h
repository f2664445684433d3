// Answers what-if questions while the robot plays: the threads, the clock and the deadline around sim/foresight.
#pragma once

#include <cstdint>
#include <deque>
#include <functional>
#include <map>
#include <memory>
#include <string>
#include <thread>
#include <tuple>
#include <vector>

#include "proto/foresight/forecast.pb.h"
#include "robot/bridge/from_messages.h"
#include "robot/bridge/player_map.h"
#include "robot/core/lock.h"
#include "robot/core/result.h"
#include "robot/foresight/rollouts.h"
#include "sim/io/playbook.h"

namespace robot::foreseeing {

namespace pb = ::foresight;

/// The rules of a game for which none are given.
inline constexpr const char* kNewestRules = "spl2025";

struct ForeseerOptions {
  std::vector<std::string> strategies;  // 1 .. 8 strategies by name or path; the first is played
  std::string rules = kNewestRules;
  std::string models = "match";           // of the own robots
  std::string opponent_models = "match";  // of the opponents
  Share share = Share::left_over;         // of the processor, for the rollouts
};

/// The team of the robot that a question is about. An opponent plays with the opponents' models against the own team.
enum class Whose : std::uint8_t { own, others };

/// Returns the team of `robot` as seen by the robot `own`, both "<team>/<player>".
Whose whose(const std::string& robot, const std::string& own);

/// The refusal of a question when no place is free.
inline constexpr const char* kBusy = "foresight is busy: one question runs and another one waits";

/// Two threads. One plays rollouts at the lowest priority. The other, at normal priority, answers at the deadline from
/// the last complete stripe, even if the rollouts got little time. All functions from any thread.
class Foreseer {
 public:
  /// Returns an Error if a strategy, the rules or the models cannot be loaded, or if the system allows no more threads.
  static Result<std::unique_ptr<Foreseer>> open(ForeseerOptions options);
  ~Foreseer();
  Foreseer(const Foreseer&) = delete;
  Foreseer& operator=(const Foreseer&) = delete;

  const std::vector<std::string>& strategies() const { return options_.strategies; }
  const sim::field::Rules& rules() const { return rules_; }

  /// Reports whether no question runs or waits.
  bool idle();

  /// Answers every question at once from the results so far. Called before the
  /// destruction, so that no caller waits long.
  void hurry();

  /// Called on the answering thread; must not wait for a question of its own.
  using Answered = std::function<void(const pb::Forecast&)>;

  /// Asks about the moment of `recollection`. One question runs and one may wait. A third question and a wrong one get
  /// an Error, and `answered` is not called. A question that cannot be answered gets an answer with a `refusal`, before
  /// this returns. The budget counts from the start of the question.
  Result<void> ask(const pb::WhatIf& question, const bridge::Recollection& recollection, Answered answered,
                   Whose robot = Whose::own);

  /// Asks in the same way, and waits for the answer.
  Result<pb::Forecast> ask_and_wait(const pb::WhatIf& question, const bridge::Recollection& recollection,
                                    Whose robot = Whose::own);

 private:
  struct Job {
    pb::WhatIf question;
    Futures futures;
    bridge::PlayerMaps lineups;
    std::uint64_t asked_ns = 0;    // [ns since the epoch] the moment of the question
    double speed = 1;              // [game seconds per second]
    std::uint64_t arrived_ns = 0;  // [monotonic]
    Answered answered;
  };

  explicit Foreseer(ForeseerOptions options);

  Result<std::shared_ptr<const sim::io::Playbook>> playbook_for(const std::string& opponent, int players, Whose robot);
  void answer();
  void answer(const Job& job);
  static pb::Forecast forecast_of(const Job& job, const Progress& progress);

  const ForeseerOptions options_;
  sim::field::Rules rules_;  // constant after open()

  Mutex preparing_;
  std::map<std::tuple<std::string, int, Whose>, std::shared_ptr<const sim::io::Playbook>> playbooks_;

  Mutex lock_;
  Condition changed_;
  std::deque<std::unique_ptr<const Job>> jobs_;  // the first runs, the others wait
  bool hurries_ = false, ending_ = false;
  Rollouts rollouts_;  // of the answering thread
  std::thread answering_;
};

}  // namespace robot::foreseeing
