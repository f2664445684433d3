#include "sim/debug/decision.h"

#include "sim/agent/behaviour.h"

namespace sim::debug {
namespace {

/// A behaviour that keeps the arguments of one player's decision.
class Witness final : public agent::Behaviour {
 public:
  Witness(const agent::Behaviour& behaviour, int robot, std::optional<Decision>& seen)
      : behaviour_(behaviour), robot_(robot), seen_(seen) {}

  const std::string& name() const override { return behaviour_.name(); }
  motion::Command decide(const agent::Surroundings& surroundings, const agent::Game& game,
                         const agent::Beliefs& beliefs, Tick now, agent::Mind& mind,
                         agent::Trace* trace) const override {
    if (game.player == player_of(robot_)) seen_ = {robot_, now, game, beliefs, mind};
    return behaviour_.decide(surroundings, game, beliefs, now, mind, trace);
  }

 private:
  const agent::Behaviour& behaviour_;
  const int robot_;
  std::optional<Decision>& seen_;
};

agent::Surroundings surroundings_of(const Params& params, int robot) {
  return {&params.rules, &models_of(params, robot).motion};
}

}  // namespace

bool decides(const State& state, int robot) {
  return state.schedule.turn[robot] <= state.world.tick && on_field(state.world.bodies[robot]);
}

std::optional<Decision> decision_in(const Params& params, const State& state, int robot) {
  if (!decides(state, robot)) return {};
  std::optional<Decision> seen;
  Params watched = params;
  Team& team = watched.teams[static_cast<int>(side_of(robot))];
  const Witness witness(*team.behaviour, robot, seen);
  team.behaviour = &witness;
  State after = state;
  referee::Events events;
  step(watched, after, events);
  return seen;
}

std::optional<Decision> decision_before(Timeline& timeline, Tick tick, int robot) {
  // back from key frame to key frame, until one part of the game has a decision
  Tick end = tick + 1;
  while (end > timeline.first()) {
    const Tick back = timeline.interval();
    const Tick begin = end - timeline.first() > back ? end - back : timeline.first();
    std::optional<State> newest;
    const auto keep = [&](const State& before) {
      if (before.world.tick < end && decides(before, robot) && !finished(before)) newest = before;
    };
    timeline.replay(begin, end, [&](const State& before, const State&, const referee::Events&) {
      keep(before);
      return true;
    });
    if (newest) return decision_in(timeline.setup_at(newest->world.tick)->params, *newest, robot);
    end = begin;
  }
  return {};
}

Outcome decide(const Params& params, const agent::Behaviour& behaviour, const Decision& decision, agent::Trace* trace) {
  Outcome outcome{.command = {}, .mind = decision.mind};
  outcome.command = behaviour.decide(surroundings_of(params, decision.robot), decision.game, decision.beliefs,
                                     decision.tick, outcome.mind, trace);
  return outcome;
}

Thought::Thought(const Params& params, const agent::Tree& tree, const Decision& decision)
    : decision_(decision),
      around_(surroundings_of(params, decision.robot)),
      mind_(decision.mind),
      view_(around_, tree.settings, decision_.game, decision_.beliefs, decision_.tick, mind_) {
  agent::prepare(view_, mind_);
}

}  // namespace sim::debug
