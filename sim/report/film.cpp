#include "sim/report/film.h"

#include <utility>

#include "sim/match/pace.h"
#include "sim/math/random.h"

namespace sim::report {
namespace {

// the film has a key of its own, so that its noise has nothing to do with the luck of the game
constexpr std::uint64_t kFilmKey = 0x66696c6d;
constexpr float kBallNoise = 0.01f, kRobotNoise = 0.015f;  // [m] standard deviations along each axis

Vec2 filmed(const World& world, std::uint8_t robot, Vec2 place, float deviation) {
  const auto words = draw({.seed = world.key.seed ^ kFilmKey}, robot, Draw::situation, world.tick);
  const auto noise = normals(words[0], words[1]);
  return {place.x + deviation * noise[0], place.y + deviation * noise[1]};
}

}  // namespace

void Film::look(const State& state) {
  if (now_.robots.empty()) begin(state.world.players);
  if (referee::in_play(state.book))
    add_frame(between_turns(state));
  else if (in_play_ > 0)
    add_empty_frame();
  if (in_play_ < statistics::kWindowFrames) return;
  windows_.push_back(std::exchange(now_, {}));
  in_play_ = 0;
}

void Film::begin(int players) {
  for_each_robot(players, [&](int robot) {
    now_.robots.push_back({.side = static_cast<int>(side_of(robot)), .player = player_of(robot), .frames = {}});
  });
}

void Film::add_empty_frame() {
  now_.ball.emplace_back();
  for (statistics::Robot& robot : now_.robots) robot.frames.emplace_back();
}

void Film::add_frame(const World& world) {
  ++in_play_;
  add_empty_frame();
  now_.ball.back() = filmed(world, kNobody, world.ball.position, kBallNoise);
  std::size_t next = 0;
  for_each_robot(world.players, [&](int robot) {
    const Body& body = world.bodies[robot];
    statistics::Robot& film = now_.robots[next++];
    if (!on_field(body)) return;
    film.frames.back() = statistics::Sighting{
        .position = filmed(world, static_cast<std::uint8_t>(robot), body.position, kRobotNoise), .down = lies(body)};
  });
}

}  // namespace sim::report
