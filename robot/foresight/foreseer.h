// Answers what-if questions while the robot plays: the thread, the clock and the deadline round sim/foresight.
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

/// Of games that nobody says more of.
inline constexpr const char* kNewestRules = "spl2025";

struct ForeseerOptions {
  std::vector<std::string> strategies;  // 1 .. 8 that can be asked about, by name or path; the first is played
  std::string rules = kNewestRules;
  std::string models = "match";           // of one's own robots
  std::string opponent_models = "match";  // of the others'
  Share share = Share::left_over;         // of the processor, for the rollouts
};

/// Whose robot a question is asked for: the others' plays with the others' models, against one's own.
enum class Whose : std::uint8_t { own, others };

/// Whose `robot` is to the robot `own`, both "<team>/<player>".
Whose whose(const std::string& robot, const std::string& own);

/// What an answer says that finds no place.
inline constexpr const char* kBusy = "foresight is busy: one question runs and another one waits";

/// Two threads: rollouts at the lowest priority, and at normal priority one that answers at the deadline from the last
/// whole stripe, however little the rollouts got. All functions from any thread.
class Foreseer {
 public:
  /// An Error if a strategy, the rules or the models cannot be had.
  static Result<std::unique_ptr<Foreseer>> open(ForeseerOptions options);
  ~Foreseer();
  Foreseer(const Foreseer&) = delete;
  Foreseer& operator=(const Foreseer&) = delete;

  const std::vector<std::string>& strategies() const { return options_.strategies; }
  const sim::field::Rules& rules() const { return rules_; }

  /// No question runs, none waits.
  bool idle();

  /// From now on every question is answered at once, by what is there. Before it goes, so that nobody waits for long.
  void hurry();

  /// Called on the answering thread; must not wait for a question of its own.
  using Answered = std::function<void(const pb::Forecast&)>;

  /// Asks from where `recollection` is. One question runs at a time, and one may wait for it: a third is refused, and so
  /// is what makes no sense; then `answered` is not called. What cannot be told is an answer, with its `refusal`; it comes
  /// before this returns. The budget counts from when the question runs.
  Result<void> ask(const pb::WhatIf& question, const bridge::Recollection& recollection, Answered answered,
                   Whose robot = Whose::own);

  /// As above, and waits for the answer.
  Result<pb::Forecast> ask_and_wait(const pb::WhatIf& question, const bridge::Recollection& recollection,
                                    Whose robot = Whose::own);

 private:
  struct Job {
    pb::WhatIf question;
    Futures futures;
    bridge::PlayerMaps lineups;
    std::uint64_t asked_ns = 0;    // [ns since the epoch] of the moment it is about
    double speed = 1;              // [game seconds per second]
    std::uint64_t arrived_ns = 0;  // [monotonic]
    Answered answered;
  };

  explicit Foreseer(ForeseerOptions options);

  Result<std::shared_ptr<const sim::io::Playbook>> playbook_for(const std::string& opponent, int players, Whose robot);
  void answer();
  void answer(const Job& job, Rollouts& rollouts);
  static pb::Forecast forecast_of(const Job& job, const Progress& progress);

  const ForeseerOptions options_;
  sim::field::Rules rules_;  // does not change once it is open

  Mutex preparing_;
  std::map<std::tuple<std::string, int, Whose>, std::shared_ptr<const sim::io::Playbook>> playbooks_;

  Mutex lock_;
  Condition changed_;
  std::deque<std::unique_ptr<const Job>> jobs_;  // the first runs, the others wait
  bool hurries_ = false, ending_ = false;
  std::thread answering_;
};

}  // namespace robot::foreseeing
