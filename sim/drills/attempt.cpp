#include "sim/drills/attempt.h"

#include <cmath>

#include "sim/match/step.h"

namespace sim::drills {

Attempt::Attempt(const Drill& drill, const State& start)
    : drill_(drill),
      start_(start),
      observer_(start),
      success_(drill.success),
      failure_(drill.failure),
      held_(drill.score.size(), false) {
  const referee::Events none{};
  const check::Glance first{.start = &start, .now = &start, .events = &none};
  for (const Progress& progress : drill.progress)
    quantity_.push_back(check::quantity(progress.quantity).compute(first));
  for (std::size_t i = 0; i < drill.score.size(); ++i) held_[i] = check::holds(drill.score[i].fact, first);
}

Outcome Attempt::see(const State& now, const referee::Events& events) {
  const check::Glance glance = observer_.look(now, events);
  success_.see(glance);
  failure_.see(glance);
  const Outcome outcome = outcome_of(now);
  points_ = points_in(glance, outcome) + (succeeded(outcome) ? 1.f : 0.f);
  score_ += points_;
  return outcome;
}

Outcome Attempt::outcome_of(const State& now) const {
  if (success_.holds()) return Outcome::success;
  if (failure_.holds()) return Outcome::failure;
  if (now.world.tick - start_.world.tick >= drill_.duration) return Outcome::time_over;
  return finished(now) ? Outcome::failure : Outcome::running;
}

bool Attempt::succeeded(Outcome outcome) const {
  return outcome == Outcome::success || (outcome == Outcome::time_over && drill_.time_is_success);
}

float Attempt::points_in(const check::Glance& glance, Outcome outcome) {
  float points = 0;
  for (std::size_t i = 0; i < held_.size(); ++i) {
    const bool holds = check::holds(drill_.score[i].fact, glance);
    if (holds && !held_[i]) points += drill_.score[i].points;
    held_[i] = holds;
  }
  // the referee may have moved the ball in the last tick
  if (outcome != Outcome::running) return points;
  for (std::size_t i = 0; i < quantity_.size(); ++i) {
    const float now = check::quantity(drill_.progress[i].quantity).compute(glance);
    const float grown = now - quantity_[i];
    if (!std::isnan(grown)) points += drill_.progress[i].points * grown;
    quantity_[i] = now;
  }
  return points;
}

}  // namespace sim::drills
