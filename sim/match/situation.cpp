#include "sim/match/situation.h"

#include "sim/match/step.h"
#include "sim/perception/perception.h"

namespace sim {
namespace {

constexpr float kRoom = 0.5f;  // [m] least distance between robots, from robot to ball, and from the lines
constexpr float kFastest = 2;  // [m/s] fastest ball

/// Four random numbers in [-1, 1).
struct Four {
  float values[4];
};
Four four(RandomKey key, int robot, std::uint32_t number) {
  const auto words = draw(key, static_cast<std::uint32_t>(robot), Draw::situation, number);
  return {{2 * uniform(words[0]) - 1, 2 * uniform(words[1]) - 1, 2 * uniform(words[2]) - 1, 2 * uniform(words[3]) - 1}};
}

bool is_free(const World& world, Vec2 place, const bool (&placed)[kMaxRobots]) {
  if (squared_length(place - world.ball.position) < kRoom * kRoom) return false;
  for (int robot = 0; robot < kMaxRobots; ++robot)
    if (placed[robot] && squared_length(place - world.bodies[robot].position) < kRoom * kRoom) return false;
  return true;
}

}  // namespace

void start_play(const Params& params, State& state) {
  referee::Book& book = state.book;
  const World& world = state.world;
  book.phase = agent::Game::Phase::playing;
  book.set_play = agent::Game::SetPlay::none;
  book.ball_free = true;
  book.last_toucher = kNobody;
  book.phase_since = book.told_phase_since = book.last_touch_tick = book.still_since = book.stuck_since = world.tick;
  book.playing_since = world.tick;
  book.stuck_at = book.last_touch_at = book.ball_before = world.ball.position;
  for_each_robot(world.players, [&](int robot) {
    if (on_field(world.bodies[robot])) enter(params, state, robot);
  });
}

void know_ball(State& state, Tick seen, float deviation) {
  const World& world = state.world;
  for_each_robot(world.players, [&](int robot) {
    if (!on_field(world.bodies[robot])) return;
    const Body& body = world.bodies[robot];
    agent::Ball& ball = state.robots[robot].beliefs.ball;
    ball = {};
    ball.position = turned_back(world.ball.position - body.position, body.facing);
    ball.velocity = turned_back(world.ball.velocity, body.facing);
    ball.variance = ball.velocity_variance = deviation * deviation;
    ball.seen = seen;
  });
  for_each_robot(world.players, [&](int sender) {
    if (!on_field(world.bodies[sender])) return;
    const agent::Mate packet =
        perception::packet_of(state.robots[sender].beliefs, state.robots[sender].mind, false, world.tick);
    for_each_robot(world.players, [&](int receiver) {
      if (receiver != sender && side_of(receiver) == side_of(sender))
        perception::receive(packet, sender, receiver, state.robots[receiver].beliefs);
    });
  });
}

State random_situation(const Params& params, RandomKey key) {
  referee::Events events;
  State state = begin(params, key, events);
  World& world = state.world;
  const Vec2 reach{params.rules.field.length / 2 - kRoom, params.rules.field.width / 2 - kRoom};
  const auto place_of = [&](const Four& drawn) { return Vec2{reach.x * drawn.values[0], reach.y * drawn.values[1]}; };

  const Four of_ball = four(key, kNobody, 0);
  place(world.ball, place_of(of_ball));
  world.ball.velocity = (kFastest * of_ball.values[2]) * direction(kPi * of_ball.values[3]);

  // each robot stands at the first random place that is free
  bool placed[kMaxRobots] = {};
  for_each_robot(world.players, [&](int robot) {
    std::uint32_t number = 0;
    Four drawn = four(key, robot, number);
    while (!is_free(world, place_of(drawn), placed)) drawn = four(key, robot, ++number);
    Body& body = world.bodies[robot];
    body = {};
    body.position = place_of(drawn);
    body.heading = kPi * drawn.values[2];
    body.facing = direction(body.heading);
    placed[robot] = true;
  });

  start_play(params, state);
  return state;
}

}  // namespace sim
