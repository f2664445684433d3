#include "robot/foresight/scorer.h"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <iterator>

#include "robot/core/json_library.h"
#include "robot/foresight/question.h"

namespace robot::foreseeing {
namespace {

bool is_edited(const pb::WhatIf& question) {
  const pb::WhatIf::Edit& edit = question.edit();
  return edit.has_ball() || edit.robots_size() > 0 || edit.has_own_score() || edit.has_opponent_score() ||
         edit.has_seconds_remaining();
}

nlohmann::json to_json(const pb::ForecastScore::Event& event) {
  nlohmann::json bins = nlohmann::json::array();
  for (const pb::ForecastScore::Bin& bin : event.bins())
    bins.push_back({{"forecasts", bin.forecasts()}, {"came", bin.came()}, {"foretold", bin.foretold()}});
  return {{"came", event.came()},
          {"brier", event.brier()},
          {"brier_of_rate", event.brier_of_rate()},
          {"log_loss", event.log_loss()},
          {"bins", std::move(bins)}};
}

bool has_horizon(const pb::WhatIf& question) {
  return question.until() == pb::WhatIf::UNTIL_HORIZON || question.until() == pb::WhatIf::UNTIL_NEXT_GOAL;
}

/// Returns one line of the report, and one for each decile with cases.
std::string lines_of(const char* what, const pb::ForecastScore::Event& event) {
  std::string deciles;
  char line[160];
  double cases = 0, foretold = 0;
  for (const pb::ForecastScore::Bin& bin : event.bins()) {
    if (bin.forecasts() == 0) continue;
    cases += bin.forecasts(), foretold += bin.forecasts() * double{bin.foretold()};
    std::snprintf(line, sizeof line, "    %-32u%6.1f %%%8.1f %%\n", bin.forecasts(),
                  100. * bin.came() / bin.forecasts(), 100 * double{bin.foretold()});
    deciles += line;
  }
  std::snprintf(line, sizeof line, "  %-34s%6.1f %%%8.1f %%%8.3f%13.3f%10.3f\n", what, 100 * event.came() / cases,
                100 * foretold / cases, double{event.brier()}, double{event.brier_of_rate()}, double{event.log_loss()});
  return line + deciles;
}

bool is_default_opponent(const std::string& opponent) { return opponent.empty() || opponent == kDefaultOpponent; }

const char* name_of(pb::ForecastScore::Against against) {
  return against == pb::ForecastScore::AGAINST_GROUND_TRUTH ? "ground truth" : "own memory";
}

std::uint64_t nanoseconds(float seconds) { return static_cast<std::uint64_t>(double{seconds} * 1e9); }

}  // namespace

Scorer::Scorer(float goal_delay) : goal_delay_(goal_delay) {}

void Scorer::foretell(const pb::Forecast& forecast, std::uint64_t capture_ns) {
  const pb::WhatIf& question = forecast.question();
  if (!seen_ || !forecast.refusal().empty() || forecast.advice() == pb::Forecast::ADVICE_NONE) return;
  if (is_edited(question) || !is_default_opponent(question.opponent())) return;
  if (!has_horizon(question) || question.strategies_size() == 0) return;
  const float speed = forecast.speed() > 0 ? forecast.speed() : 1;
  Open& open = open_.emplace_back();
  open.asked_ns = capture_ns;
  open.due_ns = capture_ns + nanoseconds(forecast.horizon() / speed);
  open.delay_ns = by_truth_ ? 0 : nanoseconds(goal_delay_ / speed);
  open.by_behaviour = question.asked_by() != kByPeople && !question.asked_by().starts_with(kByCaptain);
  // other fields are not needed, and paths are large
  open.forecast.set_horizon(forecast.horizon());
  for (const pb::Forecast::StrategyForecast& told : forecast.strategies()) {
    pb::Forecast::StrategyForecast& kept = *open.forecast.add_strategies();
    kept.set_strategy(told.strategy());
    kept.set_rollouts(told.rollouts());
    kept.set_score(told.score());
    kept.set_concede(told.concede());
  }
}

void Scorer::see(const pb::Strategy& strategy, std::uint64_t capture_ns) {
  const auto later = std::ranges::upper_bound(plays_, capture_ns, {}, &Play::from_ns);
  if (later != plays_.begin() && std::prev(later)->strategy == strategy.name()) return;
  plays_.insert(later, {.strategy = strategy.name(), .from_ns = capture_ns});
}

bool Scorer::see(const pb::GameState& game, std::uint64_t capture_ns) {
  own_team_ = game.own_team();
  const bool scored = !by_truth_ && see_goals(game.own().score(), game.opponent().score(), capture_ns);
  const bool between = game.state() == pb::GameState::STATE_FINISHED || game.state() == pb::GameState::STATE_INITIAL;
  if (between) forget_open();
  return scored;
}

bool Scorer::see(const pb::Simulation& simulation, std::uint64_t capture_ns) {
  const bool is_home = simulation.home().number() == own_team_;
  if (own_team_ == 0 || (!is_home && simulation.away().number() != own_team_)) return false;
  // the goals reported to a robot have other times, and another game has other goals
  if (!by_truth_) entries_.clear();
  if (!by_truth_ || simulation.tick() < tick_) seen_ = false, forget_open();
  by_truth_ = true;
  tick_ = simulation.tick();
  const pb::SimulatedTeam &own = is_home ? simulation.home() : simulation.away(),
                          &opponent = is_home ? simulation.away() : simulation.home();
  const bool scored = see_goals(own.score(), opponent.score(), capture_ns);
  if (simulation.finished()) forget_open();
  return scored;
}

/// Takes the score, as reported or true.
bool Scorer::see_goals(std::uint32_t own, std::uint32_t opponent, std::uint64_t capture_ns) {
  if (capture_ns < seen_ns_) {
    seen_ = false;
    forget_open();
    std::erase_if(plays_, [=](const Play& play) { return play.from_ns > capture_ns; });
  }
  if (seen_) count(own, true, capture_ns), count(opponent, false, capture_ns);
  told_ = {own, opponent};
  seen_ = true;
  seen_ns_ = capture_ns;
  bool scored = false;
  std::erase_if(open_, [&](const Open& open) {
    if (capture_ns < open.due_ns + open.delay_ns) return false;
    if (enter(open)) scored = true;
    return true;
  });
  return scored;
}

/// A withdrawn goal is the last one of that team.
void Scorer::count(std::uint32_t goals, bool own, std::uint64_t told_ns) {
  std::uint32_t& told = told_[own ? 0 : 1];
  for (; told < goals; ++told) goals_.push_back({.own = own, .told_ns = told_ns});
  for (; told > goals; --told) {
    const auto last = std::find_if(goals_.rbegin(), goals_.rend(), [=](const Goal& goal) { return goal.own == own; });
    if (last != goals_.rend()) goals_.erase(std::prev(last.base()));
  }
}

/// Returns the strategy from the question until the due time, or null if it changed.
const std::string* Scorer::played(const Open& open) const {
  if (open.by_behaviour) return &open.forecast.strategies(0).strategy();
  const auto later = std::ranges::upper_bound(plays_, open.asked_ns, {}, &Play::from_ns);
  if (later != plays_.end() && later->from_ns < open.due_ns) return nullptr;
  if (later == plays_.begin()) return &open.forecast.strategies(0).strategy();
  return &std::prev(later)->strategy;
}

/// Returns false if the forecast says nothing about the played strategy.
bool Scorer::enter(const Open& open) {
  const auto& strategies = open.forecast.strategies();
  const std::string* const strategy = strategies.empty() ? nullptr : played(open);
  if (!strategy) return false;
  const auto told = std::ranges::find(strategies, *strategy, &pb::Forecast::StrategyForecast::strategy);
  if (told == strategies.end() || told->rollouts() == 0) return false;
  const auto next = std::ranges::find_if(goals_, [&](const Goal& goal) {
    return goal.told_ns > open.asked_ns + open.delay_ns && goal.told_ns < open.due_ns + open.delay_ns;
  });
  const bool came = next != goals_.end();
  auto& [score, concede] = entries_[{*strategy, open.forecast.horizon()}];
  score.add(std::clamp(double{told->score()}, 0., 1.), came && next->own, told->rollouts());
  concede.add(std::clamp(double{told->concede()}, 0., 1.), came && !next->own, told->rollouts());
  return true;
}

void Scorer::EventScore::add(double foretold, bool came, std::uint64_t rollouts) {
  reliability.add(foretold, came);
  const double least = 0.5 / static_cast<double>(rollouts);
  const double told = std::clamp(foretold, least, 1 - least);
  log_loss -= std::log(came ? told : 1 - told);
}

void Scorer::EventScore::fill(pb::ForecastScore::Event& message) const {
  message.set_came(reliability.came);
  message.set_brier(static_cast<float>(reliability.brier()));
  message.set_brier_of_rate(static_cast<float>(reliability.brier_of_rate()));
  message.set_log_loss(static_cast<float>(log_loss / reliability.cases));
  for (const sim::foresight::Reliability::Bin& bin : reliability.bins) {
    pb::ForecastScore::Bin& told = *message.add_bins();
    told.set_forecasts(bin.cases);
    told.set_came(bin.came);
    told.set_foretold(bin.cases == 0 ? 0 : static_cast<float>(bin.foretold / bin.cases));
  }
}

pb::ForecastScore Scorer::score() const {
  pb::ForecastScore message;
  message.set_open(static_cast<std::uint32_t>(open_.size()));
  message.set_against(by_truth_ ? pb::ForecastScore::AGAINST_GROUND_TRUTH : pb::ForecastScore::AGAINST_OWN_MEMORY);
  for (const auto& [key, events] : entries_) {
    pb::ForecastScore::Entry& entry = *message.add_entries();
    entry.set_strategy(key.first);
    entry.set_horizon(key.second);
    entry.set_forecasts(events[0].reliability.cases);
    events[0].fill(*entry.mutable_score());
    events[1].fill(*entry.mutable_concede());
  }
  return message;
}

std::string to_text(const pb::ForecastScore& score) {
  std::string text;
  for (const pb::ForecastScore::Entry& entry : score.entries()) {
    char who[100], head[200];
    std::snprintf(who, sizeof who, "%.60s, %u of %g s", entry.strategy().c_str(), entry.forecasts(),
                  double{entry.horizon()});
    std::snprintf(head, sizeof head, "%-36s%8s%10s%8s%13s%10s\n", who, "came", "foretold", "Brier", "of the rate",
                  "log-loss");
    text += head + lines_of("own goal", entry.score()) + lines_of("conceded", entry.concede());
  }
  if (!text.empty()) text += std::string("  goals by ") + name_of(score.against()) + "\n";
  return text;
}

nlohmann::json to_json(const pb::ForecastScore& score) {
  nlohmann::json entries = nlohmann::json::array();
  for (const pb::ForecastScore::Entry& entry : score.entries())
    entries.push_back({{"strategy", entry.strategy()},
                       {"horizon", entry.horizon()},
                       {"forecasts", entry.forecasts()},
                       {"score", to_json(entry.score())},
                       {"concede", to_json(entry.concede())}});
  return {{"entries", std::move(entries)}, {"open", score.open()}, {"against", name_of(score.against())}};
}

}  // namespace robot::foreseeing
