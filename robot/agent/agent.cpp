#include "robot/agent/agent.h"

#include <algorithm>
#include <utility>

#include "robot/bridge/to_messages.h"
#include "sim/agent/follower.h"
#include "sim/io/strategy.h"

namespace robot::agent {

Result<std::shared_ptr<const sim::agent::Behaviour>> follower_of(const std::vector<std::string>& strategies,
                                                                 sim::Tick stale) {
  std::vector<std::shared_ptr<const sim::agent::Behaviour>> behaviours;
  for (const std::string& name : strategies) {
    auto behaviour = sim::io::load_strategy(name);
    if (!behaviour) return behaviour.failure();
    behaviours.push_back(std::move(*behaviour));
  }
  const std::string name = behaviours.front()->name();
  return std::shared_ptr<const sim::agent::Behaviour>(
      std::make_shared<sim::agent::Follower>(name, std::move(behaviours), stale));
}

Result<Agent> Agent::load(const AgentChoice& choice) {
  auto game = sim::io::prepare({.rules = choice.rules,
                                .strategies = {choice.behaviour, choice.behaviour},
                                .models = {choice.models, choice.models}});
  if (!game) return game.failure();
  if (choice.strategies.size() > 1) {
    auto follower = follower_of(choice.strategies, choice.stale);
    if (!follower) return follower.failure();
    game->behaviours[0] = std::move(*follower);
    game->params.teams[0].behaviour = game->behaviours[0].get();
  }
  return Agent(std::move(*game));
}

/// Ticks of game time since the first decision, after bridge::kNow. They never decrease.
sim::Tick Agent::tick_of(std::uint64_t now_ns) {
  if (!first_ns_) first_ns_ = now_ns;
  newest_ns_ = std::max({newest_ns_, now_ns, *first_ns_});
  return bridge::kNow + static_cast<sim::Tick>(static_cast<double>(newest_ns_ - *first_ns_) * 30e-9);
}

Agent::Decision Agent::decide(bridge::Recollection recollection) {
  Decision decision;
  recollection.now = tick_of(recollection.now_ns);
  const Result<sim::foresight::Knowledge> knowledge = bridge::knowledge_of(recollection, game_.params);
  if (!knowledge) {
    decision.command.set_posture(pb::MotionCommand::POSTURE_STAND);
    decision.problem = knowledge.error();
    return decision;
  }
  if (choice_) sim::agent::take_over(*choice_, knowledge->now, mind_);

  const sim::Team& team = game_.params.teams[0];
  sim::agent::Trace trace;
  trace.clear();
  const sim::motion::Model& body = team.models_of(knowledge->game.player).motion;
  const sim::motion::Command command =
      team.behaviour->decide({.rules = &game_.params.rules, .motion = &body}, knowledge->game, knowledge->beliefs,
                             knowledge->now, mind_, &trace);
  bridge::to_proto(command, body, decision.command);
  if (decision.command.has_kick()) {
    // the body walks to a ball that its foot does not reach yet
    decision.command.mutable_kick()->set_ball_x(knowledge->beliefs.ball.position.x);
    decision.command.mutable_kick()->set_ball_y(knowledge->beliefs.ball.position.y);
  }
  if (*trace.skill != '\0') bridge::to_proto(trace, decision.trace.emplace());
  return decision;
}

}  // namespace robot::agent
