#include "sim/foresight/chooser.h"

#include <algorithm>
#include <bit>
#include <cassert>
#include <iterator>

#include "sim/foresight/forecast.h"
#include "sim/foresight/race.h"

namespace sim::foresight {
namespace {

using Phase = agent::Game::Phase;

constexpr float kLeastApart = 2;   // [s] least time between questions: strategies do not flutter
constexpr float kBallLostFor = 4;  // [s] unseen: a reason to ask

/// Returns the time of the last event that is a reason to ask before the period ends: a stoppage, or a lost ball.
Tick last_event(const agent::Game& game, const agent::Beliefs& beliefs, Tick now) {
  const Tick since_phase = std::min(ticks(std::clamp(game.since_phase, 0.f, 3600.f)), now);
  Tick event = now - since_phase;
  if (beliefs.ball.seen != kNever) {
    const Tick lost = beliefs.ball.seen + ticks(kBallLostFor);
    if (lost <= now) event = std::max(event, lost);
  }
  return event;
}

/// Returns a random key that depends on the beliefs.
RandomKey key_of(const agent::Beliefs& beliefs, Tick now) {
  const auto bits = [](float value) { return std::uint64_t{std::bit_cast<std::uint32_t>(value)}; };
  return {(bits(beliefs.pose.pose.position.x) << 32 | bits(beliefs.ball.position.x)) ^ std::uint64_t{now} << 20};
}

}  // namespace

Chooser::Chooser(std::string name, Plans plans, const Terms& terms)
    : name_(std::move(name)),
      plans_(std::move(plans)),
      terms_(terms),
      team_(name_, {plans_.behaviours.begin(), plans_.behaviours.begin() + std::ssize(plans_.params)},
            ticks(terms_.stale)) {
  assert(plans_.params.size() >= 2 && plans_.params.size() <= static_cast<std::size_t>(kMaxStrategies));
}

motion::Command Chooser::decide(const agent::Surroundings& surroundings, const agent::Game& game,
                                const agent::Beliefs& beliefs, Tick now, agent::Mind& mind, agent::Trace* trace) const {
  const bool leads = agent::captain_of(game, beliefs, now, ticks(terms_.stale)) == game.player;
  team_.hear(game, beliefs, now, mind, leads);
  if (leads && has_reason(game, beliefs, now, mind)) ask(game, beliefs, now, mind);
  return team_.play(surroundings, game, beliefs, now, mind, trace);
}

bool Chooser::has_reason(const agent::Game& game, const agent::Beliefs& beliefs, Tick now,
                         const agent::Mind& mind) const {
  const bool in_game = game.phase == Phase::ready || game.phase == Phase::set || game.phase == Phase::playing;
  if (!in_game) return false;
  const Tick asked = agent::since(now, mind.told);
  if (asked < ticks(kLeastApart)) return false;
  return asked >= ticks(terms_.period) || now - last_event(game, beliefs, now) < asked;
}

void Chooser::ask(const agent::Game& game, const agent::Beliefs& beliefs, Tick now, agent::Mind& mind) const {
  mind.told = static_cast<std::uint16_t>(now);
  Knowledge knowledge{.now = now, .game = game, .beliefs = beliefs, .mind = mind};
  for (int i = 0; i + 1 < game.players; ++i)
    if (beliefs.mates[i].sent != kNever && !beliefs.mates[i].active)
      knowledge.away[0][agent::player_of_mate(game.player, i) - 1] = kNever;
  const Believed believed = believe(plans_.params[0], knowledge);
  if (!believed.refusal.empty()) return;

  const int count = static_cast<int>(plans_.params.size());
  const Question question{
      .horizon = ticks(terms_.horizon), .switching_cost = terms_.switching_cost, .sure = terms_.sure};
  Task task{.situation = &believed.situation,
            .strategies = count,
            .question = question,
            .outlook = &plans_.outlook,
            .key = key_of(beliefs, now)};
  for (int i = 0; i < count; ++i) task.params[i] = &plans_.params[static_cast<std::size_t>(i)];
  RolloutStatistics statistics;
  race(
      task, [this](std::int64_t rollouts) { return static_cast<double>(rollouts) / terms_.rollouts; }, {}, statistics);
  const Forecast told = forecast(statistics, question, task.key);
  if (told.advice == Forecast::Advice::none) return;
  agent::Choice choice = mind.choice;
  choose(static_cast<std::uint8_t>(told.choice), choice);
  agent::take_over(choice, now, mind);
}

}  // namespace sim::foresight
