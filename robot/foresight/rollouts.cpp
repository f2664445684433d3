#include "robot/foresight/rollouts.h"

#include <sched.h>

#include <utility>

#include "robot/core/attempt.h"
#include "robot/core/clock.h"
#include "robot/core/report.h"
#include "robot/core/thread.h"

namespace robot::foreseeing {

Result<void> Rollouts::start() {
  return start_thread(thread_, "foresee", [this] { run(); });
}

Rollouts::~Rollouts() {
  end();
  running_ = false;
  wake();
  if (thread_.joinable()) thread_.join();
}

void Rollouts::begin(Futures futures, std::uint64_t deadline_ns) {
  end();
  std::erase_if(races_, [](const auto& race) { return race->let_go.load(); });
  auto race = std::make_unique<Race>();
  race->number = ++number_;
  race->futures = std::move(futures);
  race->began_ns = monotonic_ns();
  race->deadline_ns = deadline_ns;
  races_.push_back(std::move(race));
  offered_ = races_.back().get();
  wake();
}

Progress Rollouts::progress() {
  const Progress& newest = mailbox_.newest();
  if (newest.race == number_) return newest;
  Progress nothing{.race = number_, .statistics = {}};
  if (!races_.empty()) nothing.statistics.strategies = static_cast<int>(races_.back()->futures.strategies.size());
  return nothing;
}

void Rollouts::end() {
  if (races_.empty()) return;
  races_.back()->over = true;
  // an offer that was not taken will not be taken any more
  if (Race* const untaken = offered_.exchange(nullptr)) untaken->let_go = true;
}

void Rollouts::wake() {
  ++wakes_;
  wakes_.notify_one();
}

void Rollouts::run() {
  become_background_thread("foresee");
  sched_param none{};
  if (share_ == Share::left_over) sched_setscheduler(0, SCHED_IDLE, &none);  // of this thread; needs no rights
  while (true) {
    const std::uint32_t seen = wakes_;
    if (Race* const race = offered_.exchange(nullptr)) {
      if (const Result<void> played = attempt("playing rollouts", [&] { play(*race); }); !played)
        report(Level::error, "foresight", played.error());
      race->let_go = true;
    } else if (running_) {
      wakes_.wait(seen);
    } else {
      return;
    }
  }
}

void Rollouts::play(const Race& race) {
  const Futures& futures = race.futures;
  const std::uint64_t since_ns = thread_cpu_ns();
  const auto spent = [&race](std::int64_t) {
    if (race.over) return 1.;
    return static_cast<double>(monotonic_ns() - race.began_ns) / static_cast<double>(race.deadline_ns - race.began_ns);
  };
  const auto told = [&](const sim::foresight::RolloutStatistics& statistics) {
    Progress& draft = mailbox_.draft();
    draft.race = race.number;
    draft.statistics = statistics;
    draft.computed_ns = thread_cpu_ns() - since_ns;
    mailbox_.publish();
  };
  const auto task =
      sim::io::task_of(*futures.playbook, futures.strategies, futures.situation, futures.question, futures.key);
  sim::foresight::RolloutStatistics statistics;
  sim::foresight::race(task, spent, told, statistics);
}

}  // namespace robot::foreseeing
