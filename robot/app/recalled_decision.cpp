#include "robot/app/recalled_decision.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "robot/bridge/player_map.h"
#include "robot/core/text.h"
#include "sim/io/source.h"
#include "sim/io/strategy.h"

namespace robot::app {
namespace {

namespace pb = foresight;

/// Places a body at that pose [field]. `sign` turns `field` into the robot's `team_field`.
void place(const pb::GroundTruth::TrueRobot& told, float sign, sim::Body& body) {
  body.doing = told.fallen() ? sim::Body::Doing::fallen : sim::Body::Doing::standing;
  body.position = sign * sim::Vec2{told.x(), told.y()};
  body.heading = sim::normalized(told.heading() + (sign < 0 ? sim::kPi : 0));
  body.facing = sim::direction(body.heading);
}

bool is_finite(const pb::GroundTruth& truth) {
  return std::isfinite(truth.ball().x()) && std::isfinite(truth.ball().y()) &&
         std::ranges::all_of(truth.robots(), [](const pb::GroundTruth::TrueRobot& robot) {
           return std::isfinite(robot.x()) && std::isfinite(robot.y()) && std::isfinite(robot.heading());
         });
}

/// The true state in the frame of a decision: the own side is home and attacks +x. It is known if the truth has the ball
/// and the robot itself. Otherwise nobody is on the field.
struct TrueState {
  sim::State state;
  bool is_known = false;
};
TrueState true_state(const std::optional<pb::GroundTruth>& truth, const pb::GameState& game,
                     const sim::debug::Decision& decision) {
  TrueState all;
  sim::World& world = all.state.world;
  world.tick = decision.tick;
  world.players = decision.game.players;
  sim::for_each_robot(world.players, [&](int robot) { world.bodies[robot].doing = sim::Body::Doing::removed; });
  if (!truth || !truth->has_ball() || !is_finite(*truth)) return all;

  const float sign = game.has_attacks_positive_x() && !game.attacks_positive_x() ? -1.f : 1.f;
  const bridge::PlayerMaps players(game, world.players);
  for (const pb::GroundTruth::TrueRobot& told : truth->robots()) {
    if (!told.has_team() || !told.has_player()) continue;
    const sim::Side side = told.team() == game.own_team() ? sim::Side::home : sim::Side::away;
    const int player = players.of(side).place_of(told.player());
    if (player == 0) continue;
    const int robot = sim::robot_of(side, player);
    place(told, sign, world.bodies[robot]);
    all.is_known = all.is_known || robot == decision.robot;
  }
  world.ball.position = sign * sim::Vec2{truth->ball().x(), truth->ball().y()};
  world.ball.velocity = sign * sim::Vec2{truth->ball().velocity_x(), truth->ball().velocity_y()};
  // nobody sees into the others' minds
  for (int index = 0; index + 1 < world.players; ++index) {
    const sim::agent::Mate& mate = decision.beliefs.mates[index];
    const int player = sim::agent::player_of_mate(decision.game.player, index);
    sim::agent::Mind& mind = all.state.robots[sim::robot_of(sim::Side::home, player)].mind;
    mind.role = static_cast<sim::agent::Role>(mate.role);
    mind.time_to_ball_cs = mate.time_to_ball_cs;
  }
  return all;
}

}  // namespace

KnownTrees::KnownTrees(const std::vector<std::string>& strategies) {
  for (const std::string& name : strategies)
    if (auto tree = sim::io::load_strategy(name)) trees_.emplace_back(*std::move(tree));
}

Result<KnownTrees::Tree> KnownTrees::named(const std::string& name) {
  const auto found = std::ranges::find(trees_, name, [](const Tree& tree) { return tree->name(); });
  if (found != trees_.end()) return *found;
  if (!sim::io::is_embedded("strategies", name))
    return Error{"the robot plays '" + printable(name, 60) +
                 "', and this program does not know that tree: start it with --strategies FILE"};
  auto tree = sim::io::load_strategy(name);
  if (!tree) return tree.failure();
  return trees_.emplace_back(*std::move(tree));
}

Result<RecalledDecision> explain(const bridge::Recollection& from, const std::optional<pb::GroundTruth>& truth,
                                 sim::io::PreparedGame game, KnownTrees& trees) {
  if (!from.decision) return Error{"the robot has not decided anything: there is no object decision yet"};
  const pb::DecisionTrace& recorded = from.decision->value;
  auto tree = trees.named(recorded.strategy());
  if (!tree) return tree.failure();
  game.behaviours[0] = *tree;
  game.params.teams[0].behaviour = tree->get();

  const auto knowledge = bridge::knowledge_of(from, game.params);
  if (!knowledge) return knowledge.failure();
  const sim::debug::Decision decision{.robot = sim::robot_of(sim::Side::home, knowledge->game.player),
                                      .tick = knowledge->now,
                                      .game = knowledge->game,
                                      .beliefs = knowledge->beliefs,
                                      .mind = knowledge->mind};
  const TrueState real = true_state(truth, from.game->value, decision);
  RecalledDecision recalled{
      .game = std::move(game), .tree = *std::move(tree), .why = {}, .has_truth = real.is_known, .agrees = false};
  recalled.why = sim::debug::why(recalled.game.params, *recalled.tree, decision, real.state);
  const auto& visited = recorded.visited();
  recalled.agrees = recalled.why.plays
                        ? !visited.empty() && visited[visited.size() - 1].path() ==
                                                  recalled.tree->tree().leaf_words[recalled.why.leaf].path
                        : recorded.skill() == recalled.why.skill;
  return recalled;
}

}  // namespace robot::app
