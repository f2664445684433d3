#include "sim/debug/decision_log.h"

#include "sim/agent/trace.h"

namespace sim::debug {

void for_each_decision(const Params& params, State state, int robot, const agent::TreeBehaviour& behaviour, Tick most,
                       const std::function<void(const LoggedDecision&, const State&)>& see) {
  const Tick begun = state.world.tick;
  agent::Trace trace;
  for (referee::Events events; !finished(state) && state.world.tick - begun < most; step(params, state, events)) {
    const auto decision = decision_in(params, state, robot);
    if (!decision) continue;
    decide(params, behaviour, *decision, &trace);
    LoggedDecision logged{
        .decision = *decision, .skill = trace.skill, .role = trace.role, .values = {}, .evaluation = {}};
    if (agent::plays(decision->game)) {
      logged.values = values_of(behaviour.tree(), Thought(params, behaviour.tree(), *decision).view());
      logged.evaluation = evaluate(behaviour.tree(), logged.values);
    }
    see(logged, state);
  }
}

}  // namespace sim::debug
