#include "robot/foresight/advisor.h"

#include <algorithm>
#include <mutex>
#include <utility>

#include "robot/core/attempt.h"
#include "robot/core/clock.h"
#include "robot/core/report.h"
#include "robot/core/thread.h"
#include "robot/foresight/question.h"
#include "robot/foresight/wording.h"

namespace robot::foreseeing {
namespace {

constexpr std::uint64_t kLookNs = 100'000'000;
constexpr std::size_t kMostHeard = 100;  // questions are taken within moments: more is a flood

/// Returns the answer to a question that could not be asked.
pb::Forecast refused(const pb::WhatIf& question, std::uint64_t now_ns, const std::string& sentence) {
  pb::Forecast forecast;
  *forecast.mutable_question() = question;
  forecast.set_refusal(sentence);
  forecast.set_reason(sentence);
  forecast.set_asked_ns(now_ns);
  return forecast;
}

}  // namespace

/// The listener for questions in memory.
class Advisor::Inbox final : public memory::Listener {
 public:
  explicit Inbox(Advisor& advisor) : advisor_(advisor) {}

  void on_version(const memory::VersionPtr& version) override {
    const std::lock_guard guard(advisor_.lock_);
    if (advisor_.heard_.size() < kMostHeard)
      advisor_.heard_.push_back(version);
    else
      ++advisor_.missed_;
    advisor_.woken_.notify_all();
  }

 private:
  Advisor& advisor_;
};

Advisor::Advisor(std::unique_ptr<Foreseer> foreseer, memory::Memory& memory, const memory::Channels& channels,
                 std::string robot, std::function<std::uint64_t()> now_ns, std::function<AskingOptions()> options)
    : foreseer_(std::move(foreseer)),
      strategies_(foreseer_->strategies()),
      memory_(memory),
      channels_(channels),
      robot_(std::move(robot)),
      now_ns_(std::move(now_ns)),
      options_(std::move(options)),
      following_(static_cast<int>(strategies_.size())),
      scorer_(foreseer_->rules().goal_message_delay),
      inbox_(std::make_unique<Inbox>(*this)) {
  memory_.what_if.attach(*inbox_);
}

Result<void> Advisor::start() {
  return start_thread(thread_, "advisor", [this] { run(); });
}

Advisor::~Advisor() {
  memory_.what_if.detach(*inbox_);
  {
    const std::lock_guard guard(lock_);
    running_ = false;
    woken_.notify_all();
  }
  if (thread_.joinable()) thread_.join();
  foreseer_.reset();  // first, because the last answers need the other members
}

Result<pb::Forecast> Advisor::ask(pb::WhatIf question) {
  Result<pb::Forecast> forecast = foreseer_->ask_and_wait(question, bridge::recollect(channels_, robot_, now_ns_()));
  if (forecast) keep(*forecast);
  return forecast;
}

std::string Advisor::strategy() const {
  const std::lock_guard guard(lock_);
  return strategies_[static_cast<std::size_t>(following_.choice().played())];
}

void Advisor::run() {
  become_background_thread("advisor");
  Triggers triggers(foreseer_->rules().field.length / 2);
  std::uint64_t look_ns = monotonic_ns() + kLookNs;  // time of the next check, regardless of questions
  while (running_) {
    const Result<void> advised = attempt("advice", [&] {
      if (const auto asked = next_heard(look_ns)) take_question(*asked);
      if (!running_ || monotonic_ns() < look_ns) return;
      look_ns = monotonic_ns() + kLookNs;
      look(triggers);
    });
    if (!advised) report(Level::error, "foresight", advised.error());
  }
}

/// Returns the next question in memory, and waits for one until `until_ns`.
std::shared_ptr<const memory::Version> Advisor::next_heard(std::uint64_t until_ns) {
  const std::lock_guard guard(lock_);
  while (running_ && heard_.empty() && monotonic_ns() < until_ns) woken_.wait_until(lock_, until_ns);
  if (heard_.empty()) return nullptr;
  auto first = std::move(heard_.front());
  heard_.pop_front();
  return first;
}

/// Does the checks of every tenth of a second.
void Advisor::look(Triggers& triggers) {
  const std::uint64_t now_ns = now_ns_();
  const AskingOptions options = options_();
  follow(now_ns, options);
  score(now_ns);
  captain_waits_ = false;
  std::uint64_t missed;
  {
    const std::lock_guard guard(lock_);
    missed = std::exchange(missed_, 0);
  }
  if (missed > 0)
    report(Level::warning, "foresight",
           "left " + std::to_string(missed) + " questions unanswered, which came faster than they can be read");
  if (options.on) ask_of_own_accord(bridge::recollect(channels_, robot_, now_ns), options, triggers);
}

/// Asks as the captain if there is a reason.
void Advisor::ask_of_own_accord(const bridge::Recollection& now, const AskingOptions& options, Triggers& triggers) {
  const char* const why = triggers.look(now, static_cast<std::uint64_t>(options.period * 1e9));
  if (!why || captain_asks_) return;
  pb::WhatIf question;
  question.set_asked_by(std::string(kByCaptain) + why);
  question.set_budget_ms(options.budget_ms);
  question.set_horizon(static_cast<float>(options.horizon));
  question.set_switching_cost(options.switching_cost);
  question.set_sure(options.sure);
  question.set_id(now.now_ns);
  // all are compared with the default, not with the current strategy (sim/foresight/chooser.h)
  for (const std::string& name : strategies_) question.add_strategies(name);
  const auto leader = static_cast<int>(now.game->value.own_player());
  captain_asks_ = true;
  if (foreseer_->ask(question, now, [this, leader](const pb::Forecast& forecast) { decide(forecast, leader); }))
    triggers.asked();
  else
    captain_asks_ = false, captain_waits_ = true;
}

/// Asks a question of a team's own process, which always gets an answer. While the captain waits, the
/// next free place is the captain's.
void Advisor::take_question(const memory::Version& version) {
  pb::WhatIf question;
  const std::string_view bytes = version.bytes();
  if (!question.ParseFromArray(bytes.data(), static_cast<int>(bytes.size()))) return;
  if (newest_id_ == question.id()) return;
  newest_id_ = question.id();
  if (question.asked_by().empty()) question.set_asked_by(std::string(kByTeam));
  const std::uint64_t now_ns = now_ns_();
  if (captain_waits_ && !foreseer_->idle()) return keep(refused(question, now_ns, kBusy));
  const Result<void> asked = foreseer_->ask(question, bridge::recollect(channels_, robot_, now_ns),
                                            [this](const pb::Forecast& forecast) { keep(forecast); });
  if (!asked) keep(refused(question, now_ns, asked.error()));
}

void Advisor::keep(const pb::Forecast& forecast) {
  {
    const std::lock_guard guard(lock_);
    unscored_.push_back({forecast, forecast.asked_ns()});
  }
  memory_.forecast.write(forecast, forecast.asked_ns());
}

/// Chooses by the answer to the question of this robot, player `leader`. It does not choose when it is no longer the
/// captain (for example penalised), when foresight was switched off, or when time was moved back.
void Advisor::decide(const pb::Forecast& forecast, int leader) {
  captain_asks_ = false;
  keep(forecast);
  if (!forecast.refusal().empty() || forecast.advice() == pb::Forecast::ADVICE_NONE) return;
  const auto choice = std::find(strategies_.begin(), strategies_.end(), forecast.choice());
  if (choice == strategies_.end()) return;
  std::string before, reason;
  {
    const std::lock_guard guard(lock_);
    if (!options_().on || !leads(leader) || bridge::Moment{now_ns_()}.is_before(forecast.asked_ns())) return;
    before = strategies_[static_cast<std::size_t>(following_.choice().played())];
    reason = reason_of(forecast, before, *choice);
    following_.choose(static_cast<int>(choice - strategies_.begin()), forecast.asked_ns());
    reason_ = reason;
  }
  if (before != *choice) report(Level::info, "foresight", reason);
  write_strategy(forecast.asked_ns());
}

/// Reports whether this robot is that player and the captain now.
bool Advisor::leads(int player) const {
  const auto game = memory_.game.read();
  return game && static_cast<int>(game->value().own_player()) == player && captain_of(game->value()) == player;
}

/// Takes over the choice of another captain.
void Advisor::follow(std::uint64_t now_ns, const AskingOptions& options) {
  const auto game = memory_.game.read();
  const auto team = memory_.team.read();
  const bridge::Moment now = bridge::moment_of(channels_, now_ns);
  bool due = false;
  {
    const std::lock_guard guard(lock_);
    const auto before = following_.choice();
    const int player = game ? static_cast<int>(game->value().own_player()) : 0;
    captain_ = game ? captain_of(game->value()) : 0;
    if (team) following_.hear(team->value(), captain_, player, now);
    const bool leads = options.on && captain_ != 0 && captain_ == player;
    following_.forget(now, leads ? static_cast<std::uint64_t>(options.period * 1e9) : 0);
    const auto after = following_.choice();
    if (after.epoch != before.epoch || after.strategy != before.strategy) reason_.clear(), due = true;
    due = due || now_ns >= written_ns_ + kSecond || now_ns < written_ns_;
  }
  if (due) write_strategy(now_ns);
}

void Advisor::write_strategy(std::uint64_t now_ns) {
  auto message = memory_.strategy.draft();
  {
    const std::lock_guard guard(lock_);
    const sim::agent::Choice choice = following_.choice();
    message->set_name(strategies_[static_cast<std::size_t>(choice.played())]);
    message->set_number(static_cast<std::uint32_t>(choice.played()));
    message->set_epoch(choice.epoch);
    message->set_chosen(choice.strategy != sim::agent::kNoStrategy);
    message->set_captain(static_cast<std::uint32_t>(captain_));
    message->set_told_ns(following_.told_ns());
    message->set_reason(reason_);
    written_ns_ = now_ns;
    played_.push_back({*message, now_ns});
  }
  memory_.strategy.write(std::move(message), now_ns);
}

void Advisor::score(std::uint64_t now_ns) {
  std::vector<bridge::Remembered<pb::Forecast>> forecasts;
  std::vector<bridge::Remembered<pb::Strategy>> played;
  {
    const std::lock_guard guard(lock_);
    forecasts.swap(unscored_);
    played.swap(played_);
  }
  for (const auto& strategy : played) scorer_.see(strategy.value, strategy.capture_ns);
  for (const auto& forecast : forecasts) scorer_.foretell(forecast.value, forecast.capture_ns);
  const auto game = memory_.game.read();
  const auto simulation = memory_.simulation.read();
  const bool told = game && scorer_.see(game->value(), now_ns);
  const bool so = simulation && scorer_.see(simulation->value(), simulation->capture_ns());
  if (told || so) memory_.forecast_score.write(scorer_.score(), now_ns);
}

}  // namespace robot::foreseeing
