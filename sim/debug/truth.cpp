#include "sim/debug/truth.h"

#include <bit>
#include <cmath>
#include <cstdint>
#include <functional>

#include "robot/core/text.h"
#include "sim/math/angles.h"

namespace sim::debug {

using agent::Beliefs;

namespace {

using robot::formatted;

/// Returns the point of the field as the side of `robot` sees it [m, team_field].
Vec2 in_team(const World& world, int robot, Vec2 in_field) { return attack_sign(world, side_of(robot)) * in_field; }
Pose2 pose_in_team(const World& world, int robot, const Body& body) {
  const float turned = attack_sign(world, side_of(robot)) > 0 ? 0 : kPi;
  return {in_team(world, robot, body.position), normalized(body.heading + turned)};
}

/// A source, and some ways to change it alone.
struct Variation {
  Source source;
  std::vector<std::function<void(Decision&)>> changes;
};

constexpr Vec2 kSteps[] = {{0.02f, 0.013f}, {-0.2f, 0.15f}, {0.4f, -0.9f}, {-2.3f, -1.1f}};  // [m]

Variation of_ball(const Decision& decision, const Beliefs& truth) {
  const agent::Ball& ball = decision.beliefs.ball;
  Variation ways{.source = {.kind = Source::Kind::ball}, .changes = {}};
  ways.source.age = ball.seen == kNever ? -1 : age(decision.tick, ball.seen);
  ways.source.error = ball.seen == kNever ? 0 : distance(ball.position, truth.ball.position);
  for (const Vec2 step : kSteps) {
    ways.changes.push_back(
        [step](Decision& changed) { changed.beliefs.ball.position = changed.beliefs.ball.position + step; });
    ways.changes.push_back(
        [step](Decision& changed) { changed.beliefs.ball.velocity = changed.beliefs.ball.velocity + step; });
  }
  ways.changes.push_back([](Decision& changed) {
    changed.beliefs.ball.variance += 0.01f;
    changed.beliefs.ball.heat = 1 - changed.beliefs.ball.heat;
    changed.beliefs.ball.visible = !changed.beliefs.ball.visible;
  });
  ways.changes.push_back([](Decision& changed) { changed.beliefs.ball.seen = changed.tick; });
  ways.changes.push_back([](Decision& changed) { changed.beliefs.ball.seen = kNever; });
  return ways;
}

Variation of_pose(const Decision& decision, const Beliefs& truth) {
  Variation ways{.source = {.kind = Source::Kind::pose}, .changes = {}};
  ways.source.error = distance(decision.beliefs.pose.pose.position, truth.pose.pose.position);
  for (const Vec2 step : kSteps)
    ways.changes.push_back([step](Decision& changed) {
      agent::Pose& pose = changed.beliefs.pose;
      pose.pose = {pose.pose.position + step, normalized(pose.pose.heading + step.y)};
      pose.deviation += 0.01f;
    });
  return ways;
}

Variation of_mate(const Decision& decision, const Beliefs& truth, int index) {
  const agent::Mate& mate = decision.beliefs.mates[index];
  Variation ways{.source = {.kind = Source::Kind::mate}, .changes = {}};
  ways.source.player = agent::player_of_mate(decision.game.player, index);
  ways.source.age = mate.sent == kNever ? -1 : age(decision.tick, mate.sent);
  ways.source.error = truth.mates[index].active ? distance(mate.pose.position, truth.mates[index].pose.position) : 0.f;
  for (const Vec2 step : kSteps)
    ways.changes.push_back([index, step](Decision& changed) {
      agent::Mate& other = changed.beliefs.mates[index];
      other.pose.position = other.pose.position + step;
      other.ball = other.ball + step;
      other.time_to_ball_cs = static_cast<std::uint16_t>(other.time_to_ball_cs / 2);
    });
  ways.changes.push_back([index](Decision& changed) { changed.beliefs.mates[index].active ^= true; });
  ways.changes.push_back([index](Decision& changed) { changed.beliefs.mates[index].ball_age = 0xffff; });
  return ways;
}

Variation of_opponent(const Decision& decision, const Beliefs& truth, int index) {
  const agent::Opponent& opponent = decision.beliefs.opponents[index];
  Variation ways{.source = {.kind = Source::Kind::opponent}, .changes = {}};
  ways.source.player = index + 1;
  ways.source.age = opponent.seen == kNever ? -1 : age(decision.tick, opponent.seen);
  ways.source.error = truth.opponents[index].seen != kNever && opponent.seen != kNever
                          ? distance(opponent.position, truth.opponents[index].position)
                          : 0.f;
  for (const Vec2 step : kSteps)
    ways.changes.push_back([index, step](Decision& changed) {
      agent::Opponent& other = changed.beliefs.opponents[index];
      other.position = other.position + step;
    });
  ways.changes.push_back([index](Decision& changed) { changed.beliefs.opponents[index].seen = kNever; });
  return ways;
}

Variation of_memory() {
  Variation ways{.source = {.kind = Source::Kind::memory}, .changes = {}};
  ways.changes.push_back([](Decision& changed) {
    agent::Mind& mind = changed.mind;
    mind.ball = mind.ball + Vec2{0.3f, 0.2f};
    mind.leaf_since = changed.tick, mind.role_since = changed.tick;
    mind.kick_direction = normalized(mind.kick_direction + 0.4f);
    mind.kick ^= 1, mind.aligned ^= 1, mind.slot ^= 2;
    mind.time_to_ball_cs = static_cast<std::uint16_t>(mind.time_to_ball_cs / 2);
    mind.role = mind.role == agent::Role::supporter ? agent::Role::chaser : agent::Role::supporter;
  });
  return ways;
}

Variation of_game() {
  Variation ways{.source = {.kind = Source::Kind::game}, .changes = {}};
  ways.changes.push_back([](Decision& changed) {
    agent::Game& game = changed.game;
    game.own_kick ^= true, game.own_score ^= 1, game.half ^= 3;
    game.set_play =
        game.set_play == agent::Game::SetPlay::none ? agent::Game::SetPlay::kick_in : agent::Game::SetPlay::none;
    game.remaining /= 2, game.since_phase /= 2;
  });
  return ways;
}

}  // namespace

Beliefs true_beliefs(const State& state, int robot) {
  const World& world = state.world;
  const Body& self = world.bodies[robot];
  const auto in_robot = [&](Vec2 in_field) { return turned_back(in_field, self.facing); };
  Beliefs truth;
  truth.ball.position = in_robot(world.ball.position - self.position);
  truth.ball.velocity = in_robot(world.ball.velocity);
  truth.ball.heat = state.robots[robot].beliefs.ball.heat;
  truth.ball.seen = world.tick;
  truth.ball.visible = true;
  truth.pose.pose = pose_in_team(world, robot, self);
  for (int index = 0; index + 1 < world.players; ++index) {
    const int other = robot_of(side_of(robot), agent::player_of_mate(player_of(robot), index));
    if (!on_field(world.bodies[other])) continue;
    const agent::Mind& mind = state.robots[other].mind;
    agent::Mate& mate = truth.mates[index];
    mate.pose = pose_in_team(world, other, world.bodies[other]);
    mate.ball = in_team(world, robot, world.ball.position);
    mate.sent = world.tick;
    mate.ball_age = 0;
    mate.time_to_ball_cs = mind.time_to_ball_cs;
    mate.role = static_cast<std::uint8_t>(mind.role);
    mate.active = true;
    mate.choice = mind.choice;
  }
  for (int index = 0; index < world.players; ++index) {
    const Body& body = world.bodies[robot_of(other(side_of(robot)), index + 1)];
    if (on_field(body)) truth.opponents[index] = {in_team(world, robot, body.position), world.tick};
  }
  return truth;
}

std::vector<Source> sources_of(agent::Feature feature, const Params& params, const agent::Tree& tree,
                               const Decision& decision, const State& state) {
  const Beliefs truth = true_beliefs(state, decision.robot);
  std::vector<Variation> all{of_ball(decision, truth), of_pose(decision, truth), of_memory(), of_game()};
  for (int index = 0; index + 1 < decision.game.players; ++index) all.push_back(of_mate(decision, truth, index));
  for (int index = 0; index < decision.game.players; ++index) all.push_back(of_opponent(decision, truth, index));

  // a change of a belief can also change the role; so the role stays the one of this decision
  const agent::Role role = Thought(params, tree, decision).mind().role;
  const auto bits = [&](const Decision& changed) {
    Decision settled = changed;
    if (settled.mind.leaf == agent::kNoLeaf) settled.mind.leaf = 0;
    settled.mind.settled = static_cast<std::uint8_t>(settled.tick);
    return std::bit_cast<std::uint32_t>(value_of(feature, Thought(params, tree, settled).view()));
  };
  Decision settled = decision;
  settled.mind.role = role;
  const std::uint32_t value = bits(settled);
  std::vector<Source> sources;
  for (const Variation& ways : all)
    for (const auto& change : ways.changes) {
      Decision changed = settled;
      change(changed);
      if (bits(changed) == value) continue;
      sources.push_back(ways.source);
      break;
    }
  return sources;
}

std::string text_of(const Source& source) {
  constexpr const char* kNames[] = {"ball", "own pose", "teammate", "opponent", "memory", "game"};
  std::string text = kNames[static_cast<int>(source.kind)];
  if (source.player > 0) text += " " + std::to_string(source.player);
  if (source.kind == Source::Kind::memory || source.kind == Source::Kind::game) return text;
  if (source.kind != Source::Kind::pose) {
    const char* verb = source.kind == Source::Kind::mate ? "heard" : "seen";
    if (source.age < 0) return text + " never " + verb;
    text += formatted(" %s %.1f s ago", verb, static_cast<double>(source.age));
  }
  if (std::isnan(source.error)) return text;
  const char* comma = source.kind == Source::Kind::pose ? "" : ",";
  return text + formatted("%s %.2f m off", comma, static_cast<double>(source.error));
}

}  // namespace sim::debug
