#include "robot/foresight/scorer.h"

#include <algorithm>
#include <cmath>
#include <cstdio>

#include "robot/core/clock.h"

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

/// What was played from then on: the choice where the captain asked, else what was played already.
const std::string& played(const pb::Forecast& forecast) {
  const bool by_captain = forecast.question().asked_by().starts_with("captain");
  return by_captain ? forecast.choice() : forecast.question().strategies(0);
}

}  // namespace

void Scorer::foretell(const pb::Forecast& forecast, std::uint64_t capture_ns) {
  const pb::WhatIf& question = forecast.question();
  if (!seen_ || !forecast.refusal().empty() || is_edited(question) || !has_horizon(question)) return;
  if (question.strategies_size() == 0) return;
  const auto& strategies = forecast.strategies();
  const auto told = std::ranges::find(strategies, played(forecast), &pb::Forecast::StrategyForecast::strategy);
  if (told == strategies.end() || told->rollouts() == 0) return;
  open_.push_back({.strategy = told->strategy(),
                   .horizon = forecast.horizon(),
                   .due_ns = capture_ns + static_cast<std::uint64_t>(double{forecast.horizon()} * 1e9),
                   .rollouts = told->rollouts(),
                   .score = std::clamp(double{told->score()}, 0., 1.),
                   .concede = std::clamp(double{told->concede()}, 0., 1.),
                   .own = own_,
                   .others = others_});
}

bool Scorer::see(const pb::GameState& game, std::uint64_t capture_ns) {
  own_ = game.own().score();
  others_ = game.opponent().score();
  seen_ = true;
  const bool over = game.state() == pb::GameState::STATE_FINISHED || game.state() == pb::GameState::STATE_INITIAL;
  bool scored = false;
  std::erase_if(open_, [&](Open& open) {
    const bool due = capture_ns >= open.due_ns;
    if (!due && open.next == 0 && own_ > open.own) open.next = 1;
    if (!due && open.next == 0 && others_ > open.others) open.next = -1;
    if (over && !due) return true;
    if (!due && open.next == 0) return false;
    auto& [score, concede] = entries_[{open.strategy, open.horizon}];
    score.add(open.score, open.next > 0, open.rollouts);
    concede.add(open.concede, open.next < 0, open.rollouts);
    return scored = true;
  });
  return scored;
}

void Scorer::Event::add(double foretold, bool came, std::uint64_t rollouts) {
  reliability.add(foretold, came);
  const double least = 0.5 / static_cast<double>(rollouts);
  const double told = std::clamp(foretold, least, 1 - least);
  log_loss -= std::log(came ? told : 1 - told);
}

void Scorer::Event::fill(pb::ForecastScore::Event& message) const {
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
  if (score.entries_size() > 0)
    text = "forecasts        horizon  scored  own goal came  Brier  of the rate  conceded  Brier  of the rate\n";
  for (const pb::ForecastScore::Entry& entry : score.entries()) {
    char line[200];
    std::snprintf(line, sizeof line, "%-15s %6.0f s %7u %14u %6.3f %12.3f %9u %6.3f %12.3f\n", entry.strategy().c_str(),
                  double{entry.horizon()}, entry.forecasts(), entry.score().came(), double{entry.score().brier()},
                  double{entry.score().brier_of_rate()}, entry.concede().came(), double{entry.concede().brier()},
                  double{entry.concede().brier_of_rate()});
    text += line;
  }
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
  return {{"entries", std::move(entries)}, {"open", score.open()}};
}

}  // namespace robot::foreseeing
