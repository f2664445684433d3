#include "tests/sim/agent/scene.h"

#include <gtest/gtest.h>

#include "sim/io/models.h"
#include "sim/io/rules.h"
#include "sim/io/strategy.h"

namespace sim::agent {
namespace {

float between(std::mt19937& random, float least, float most) {
  return least + (most - least) * static_cast<float>(random() >> 8) * 0x1p-24f;
}
int up_to(std::mt19937& random, int most) { return static_cast<int>(random() % static_cast<unsigned>(most + 1)); }
bool one_in(std::mt19937& random, unsigned count) { return random() % count == 0; }

Vec2 anywhere(std::mt19937& random) { return {between(random, -3.3f, 3.3f), between(random, -2.3f, 2.3f)}; }
Pose2 any_pose(std::mt19937& random) { return {anywhere(random), between(random, -3.14f, 3.14f)}; }
Tick lately(std::mt19937& random, Tick now) {
  if (one_in(random, 6)) return kNever;
  return now - static_cast<Tick>(up_to(random, one_in(random, 3) ? 600 : 40));
}

}  // namespace

const Surroundings& surroundings() {
  static const field::Rules rules = io::load_rules("spl2012").value();
  static const Models models = io::load_models("match").value();
  static const Surroundings around{&rules, &models.motion};
  return around;
}

Scene::Scene() {
  game.phase = Game::Phase::playing;
  game.player = 2;
  game.remaining = 300;
  see_ball({1, 0});
}

void Scene::see_ball(Vec2 in_robot) {
  beliefs.ball = {};
  beliefs.ball.position = in_robot;
  beliefs.ball.variance = 0.01f;
  beliefs.ball.seen = now;
  beliefs.ball.visible = true;
}

Mate& Scene::hear(int player, Vec2 position, float time_to_ball, Role role, float ago) {
  Mate& mate = beliefs.mates[player < game.player ? player - 1 : player - 2];
  mate = {};
  mate.pose.position = position;
  mate.time_to_ball_cs = centiseconds(time_to_ball);
  mate.sent = now - ticks(ago);
  mate.role = static_cast<std::uint8_t>(role);
  mate.active = true;
  return mate;
}

Scene random_scene(std::mt19937& random) {
  Scene scene;
  Game& game = scene.game;
  game.players = static_cast<std::uint8_t>(1 + up_to(random, 6));
  game.player = static_cast<std::uint8_t>(1 + up_to(random, game.players - 1));
  game.set_play = one_in(random, 3) ? static_cast<Game::SetPlay>(up_to(random, 4)) : Game::SetPlay::none;
  game.own_kick = one_in(random, 2);
  game.own_score = static_cast<std::uint8_t>(up_to(random, 5));
  game.opponent_score = static_cast<std::uint8_t>(up_to(random, 5));
  game.since_phase = between(random, 0, 60);
  scene.now = 2000 + static_cast<Tick>(up_to(random, 20000));

  Ball& ball = scene.beliefs.ball;
  const float reach = one_in(random, 3) ? 0.3f : 3;
  ball.position = {between(random, -reach, reach), between(random, -reach, reach)};
  if (one_in(random, 3)) ball.velocity = {between(random, -1.5f, 1.5f), between(random, -1.5f, 1.5f)};
  ball.variance = between(random, 0, 1);
  ball.heat = between(random, 0, 1);
  ball.seen = lately(random, scene.now);
  ball.visible = ball.seen == scene.now;

  scene.beliefs.pose = {any_pose(random), between(random, 0, 1), between(random, 0, 1)};
  for (Mate& mate : scene.beliefs.mates) {
    mate.pose = any_pose(random);
    mate.ball = anywhere(random);
    mate.time_to_ball_cs = centiseconds(between(random, 0, 30));
    mate.sent = lately(random, scene.now);
    mate.ball_age = one_in(random, 4) ? std::uint16_t{0xffff} : static_cast<std::uint16_t>(up_to(random, 300));
    mate.role = static_cast<std::uint8_t>(up_to(random, 3));
    mate.active = !one_in(random, 5);
  }
  for (Opponent& opponent : scene.beliefs.opponents) opponent = {anywhere(random), lately(random, scene.now)};

  Mind& mind = scene.mind;
  mind.role = static_cast<Role>(up_to(random, 3));
  mind.slot = static_cast<std::uint8_t>(3 + up_to(random, 10));
  mind.leaf = static_cast<std::uint16_t>(up_to(random, 8));
  mind.ball = anywhere(random);
  mind.ball_seen = lately(random, scene.now);
  mind.search_side = one_in(random, 2) ? 1 : -1;
  mind.search_since = lately(random, scene.now);
  mind.kick_direction = between(random, -3.14f, 3.14f);
  mind.kick = static_cast<std::uint8_t>(up_to(random, 2));
  mind.aligned = static_cast<std::uint8_t>(up_to(random, 5));
  return scene;
}

Tree tree_of(std::string_view text) {
  auto tree = io::parse_strategy(text, "strategy 'test'");
  EXPECT_TRUE(tree) << (tree ? "" : tree.error());
  return tree ? *tree : Tree{};
}

Tree shipped(const char* name) {
  auto behaviour = io::load_strategy(name);
  EXPECT_TRUE(behaviour) << (behaviour ? "" : behaviour.error());
  return behaviour ? (*behaviour)->tree() : Tree{};
}

}  // namespace sim::agent
