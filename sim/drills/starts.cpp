#include "sim/drills/starts.h"

#include "sim/io/situation.h"
#include "sim/match/situation.h"

namespace sim::drills {
namespace {

constexpr float kRoomToBall = 0.2f, kRoomToRobot = 0.4f;  // [m] between middles
constexpr std::uint32_t kTries = 50;
constexpr float kKnownDeviation = 0.1f;  // [m] and [m/s] of a ball just seen

float between(float least, float most, std::uint32_t word) { return least + uniform(word) * (most - least); }
Vec2 between(Vec2 least, Vec2 most, std::uint32_t x, std::uint32_t y) {
  return {between(least.x, most.x, x), between(least.y, most.y, y)};
}

/// Draws the places of ball and robots. `number` distinguishes the draws of one game.
void draw_places(const World& least, const World& most, std::uint32_t number, World& world) {
  const auto words = [&](int robot) {
    return sim::draw(world.key, static_cast<std::uint32_t>(robot), Draw::drill, number);
  };
  const auto of_ball = words(kNobody);
  place(world.ball, between(least.ball.position, most.ball.position, of_ball[0], of_ball[1]));
  world.ball.velocity = between(least.ball.velocity, most.ball.velocity, of_ball[2], of_ball[3]);
  for_each_robot(world.players, [&](int robot) {
    const Body &from = least.bodies[robot], &to = most.bodies[robot];
    const auto drawn = words(robot);
    Body& body = world.bodies[robot];
    body.position = between(from.position, to.position, drawn[0], drawn[1]);
    body.heading = normalized(between(from.heading, to.heading, drawn[2]));
    body.facing = direction(body.heading);
  });
}

/// Returns whether all have room.
bool is_roomy(const World& world) {
  bool roomy = true;
  for_each_robot(world.players, [&](int robot) {
    if (!on_field(world.bodies[robot])) return;
    const Vec2 place = world.bodies[robot].position;
    roomy &= squared_length(place - world.ball.position) >= kRoomToBall * kRoomToBall;
    for_each_robot(world.players, [&](int other) {
      if (other < robot && on_field(world.bodies[other]))
        roomy &= squared_length(place - world.bodies[other].position) >= kRoomToRobot * kRoomToRobot;
    });
  });
  return roomy;
}

}  // namespace

robot::Result<Starts> Starts::prepare(const Drill& drill, const Params& params) {
  Starts starts;
  for (const bool most : {false, true}) {
    const auto state =
        io::parse_situation(most ? drill.most : drill.least, "drill '" + drill.name + "': start", params);
    if (!state) return state.failure();
    (most ? starts.most_ : starts.least_) = *state;
  }
  starts.ball_known_ = drill.ball_known;
  return starts;
}

State Starts::draw(const Params& params, RandomKey key) const {
  State state = least_;
  World& world = state.world;
  world.key = key;
  for (std::uint32_t number = 0; number < kTries; ++number) {
    draw_places(least_.world, most_.world, number, world);
    if (is_roomy(world)) break;
  }
  start_play(params, state);
  // a start may be before the kick-off, or a set play
  state.book.phase = least_.book.phase;
  state.book.set_play = least_.book.set_play;
  state.book.ball_free = least_.book.ball_free;
  if (ball_known_) know_ball(state, world.tick, kKnownDeviation);
  return state;
}

}  // namespace sim::drills
