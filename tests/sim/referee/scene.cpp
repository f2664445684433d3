#include "tests/sim/referee/scene.h"

#include <cstdlib>

#include "tests/sim/support/fields.h"

namespace sim::referee {
namespace {

constexpr Tick kLongest = 200'000;

}  // namespace

field::Rules rules_2012() {
  field::Rules rules{};
  rules.field = kField2012;
  rules.ball_out = field::BallOut::placed_back;
  rules.players = 4;
  rules.halves = 2;
  rules.half_duration = 600;
  rules.ready_duration = 45;
  rules.set_duration = 5;
  rules.kick_off_duration = 10;
  rules.clear_distance = 0.6f;
  rules.mercy_goals = 10;
  rules.out_inset = 0.4f;
  rules.out_set_back = 1;
  rules.penalty_duration = 30;
  rules.pushing_time = 3;
  rules.illegal_defender = true;
  rules.stuck_local = 30;
  rules.stuck_global = 30;
  return rules;
}

field::Rules rules_2025() {
  field::Rules rules = rules_2012();
  rules.field.length = 9;
  rules.field.width = 6;
  rules.field.centre_circle_radius = 0.75f;
  rules.field.goal_width = 1.6f;
  rules.ball_out = field::BallOut::set_play;
  rules.players = 7;
  rules.set_play_duration = 30;
  rules.clear_distance = 0.75f;
  rules.goal_message_delay = 15;
  rules.out_inset = rules.out_set_back = 0;
  rules.penalty_duration = 45;
  rules.penalty_step = 10;
  rules.illegal_defender = false;
  return rules;
}

Scene::Scene(const field::Rules& given, std::uint64_t seed) : rules(given) {
  world.key.seed = seed;
  Events now;
  open(params(), world, book, now);
  events.assign(now.list.begin(), now.list.begin() + now.count);
}

void Scene::pass() {
  // a test that waits in vain ends here
  if (world.tick > kLongest) std::abort();
  Events now;
  judge(params(), world, book, counts, now);
  events.insert(events.end(), now.list.begin(), now.list.begin() + now.count);
  ++world.tick;
  world.touched = world.kicked = world.whiffed = kNobody;
}

void Scene::start_play() {
  while (!book.ball_free && book.phase != agent::Game::Phase::finished) pass();
  told();
}

void Scene::touch(Side side, int player) {
  world.touched = static_cast<std::uint8_t>(robot_of(side, player));
  pass();
}

void Scene::carry(Side side, int player, Vec2 from, Vec2 to) {
  ball().position = from;
  touch(side, player);
  ball().position = to;
  pass();
}

void Scene::stand(Side side, int player, Vec2 at) { robot(side, player).position = at; }

std::vector<std::string> Scene::told() {
  Names names;
  for (; read_ < events.size(); ++read_) {
    const Event& event = events[read_];
    const bool of_nobody = event.kind == Event::Kind::half_time || event.kind == Event::Kind::end;
    names.push_back(std::string(name_of(event.kind)) + (of_nobody ? "" : event.side == Side::home ? " home" : " away"));
  }
  return names;
}

}  // namespace sim::referee
