#include "sim/agent/mirror.h"

#include "sim/agent/roles.h"

namespace sim::agent {
namespace {

Vec2 across(Vec2 a) { return {a.x, -a.y}; }
Pose2 across(Pose2 pose) { return {across(pose.position), -pose.heading}; }

Comparison turned_round(Comparison comparison) {
  switch (comparison) {
    case Comparison::less: return Comparison::greater;
    case Comparison::at_most: return Comparison::at_least;
    case Comparison::greater: return Comparison::less;
    case Comparison::at_least: return Comparison::at_most;
    case Comparison::equal:
    case Comparison::unequal: break;
  }
  return comparison;
}

}  // namespace

Beliefs mirrored(Beliefs beliefs) {
  beliefs.ball.position = across(beliefs.ball.position);
  beliefs.ball.velocity = across(beliefs.ball.velocity);
  beliefs.pose.pose = across(beliefs.pose.pose);
  for (Mate& mate : beliefs.mates) mate.pose = across(mate.pose), mate.ball = across(mate.ball);
  for (Opponent& opponent : beliefs.opponents) opponent.position = across(opponent.position);
  return beliefs;
}

Mind mirrored(Mind mind) {
  mind.slot = static_cast<std::uint8_t>(2 * kMiddleLane - mind.slot);
  mind.ball = across(mind.ball);
  mind.search_side = static_cast<std::int8_t>(-mind.search_side);
  mind.kick_direction = -mind.kick_direction;
  return mind;
}

motion::Command mirrored(motion::Command command) {
  command.kick_left = command.body == motion::Command::Body::kick && !command.kick_left;
  command.walk = across(command.walk);
  command.turn = -command.turn;
  // angles: the yaw; look_to: y
  if (command.head == motion::Command::Head::angles) command.look[0] = -command.look[0];
  if (command.head == motion::Command::Head::look_to) command.look[1] = -command.look[1];
  return command;
}

Tree mirrored(Tree tree) {
  for (Node& node : tree.nodes) {
    if (!info_of(node.feature).lateral) continue;
    // both features of a comparison change their sign, or neither
    node.comparison = turned_round(node.comparison);
    node.threshold = -node.threshold;
  }
  for (Leaf& leaf : tree.leaves)
    for (int i = 0; i < info_of(leaf.skill).count; ++i)
      if (info_of(leaf.skill).parameters[i].range.lateral) leaf.arguments[i] = -leaf.arguments[i];
  for (Vec2& place : tree.settings.formation.ours) place = across(place);
  for (Vec2& place : tree.settings.formation.theirs) place = across(place);
  return tree;
}

}  // namespace sim::agent
