#include "sim/agent/walk.h"

namespace sim::agent {
namespace {

constexpr float kLookAhead = 1.5f;     // [m] robots farther away are ignored
constexpr float kMateMemory = 5;       // [s] a teammate's place is avoided for this time
constexpr float kCarpetEdge = 0.2f;    // [m] ways stay this far from the edge of the carpet
constexpr float kNearlyThere = 0.36f;  // tangent of the heading error at which it stands still

/// Returns whether the straight way to `target` comes nearer to `centre` than `radius`.
bool in_the_way(Vec2 centre, float radius, Vec2 target) {
  const float along = dot(centre, target);
  const float squared = squared_length(target);
  const float off = cross(target, centre);
  return (along > 0) & (along < squared) & (off * off < radius * radius * squared);
}

/// Returns whether a place [team_field] is on the carpet, and not at its edge.
bool on_carpet(const View& view, Vec2 place) {
  const float beyond = view.around.rules->field.border - kCarpetEdge;
  return std::abs(place.x) < view.half_length + beyond && std::abs(place.y) < view.half_width + beyond;
}

}  // namespace

Vec2 round_circle(const View& view, Vec2 centre, float radius, Vec2 target, float side_if_even) {
  if (!in_the_way(centre, radius, target)) return target;
  const float far = length(centre);
  const Vec2 to_centre = far > 1e-3f ? (1 / far) * centre : Vec2{1, 0};
  const float offset = cross(centre, target);
  const float shorter = offset != 0 ? sign(offset) : side_if_even;

  // along the tangent; from inside the circle also outwards
  const float sine = radius < far ? radius / far : 1;
  const float cosine = std::sqrt(1 - sine * sine);
  const float way = far * cosine > 0.25f ? far * cosine : 0.25f;
  const Vec2 inside = radius > far ? (radius - far) * to_centre : Vec2{};
  const auto step = [&](float side) {
    return way * (cosine * to_centre + (side * sine) * left_of(to_centre)) - inside;
  };
  const Vec2 first = step(shorter);
  return on_carpet(view, view.to_team(first)) ? first : step(-shorter);
}

Vec2 round_robots(const View& view, Vec2 target) {
  const float radius = view.settings.habits.avoid_radius;
  const float squared = squared_length(target);
  if (squared < 0.15f * 0.15f) return target;

  // robots farther away than this (squared) are not in the way; the factor allows for rounding
  const float reach = 1.001f * (squared + radius * radius);
  float least = reach < kLookAhead * kLookAhead ? reach : kLookAhead * kLookAhead;

  // find the nearest robot in the way; most are too far away, and nothing else of them is read
  const Vec2 here = view.position, way = turned(target, view.facing);
  const float width = radius * radius * squared;
  const int players = view.game.players;
  bool found = false;
  Vec2 nearest;
  const auto consider = [&](Vec2 place, auto&& believed) {
    const Vec2 offset = place - here;
    const float far = squared_length(offset);
    if (!(far < least)) return;
    const float along = dot(offset, way), off = cross(way, offset);
    if ((along > 0) & (along < squared) & (off * off < width) && believed())
      found = true, nearest = offset, least = far;
  };
  for (int i = 0; i < players; ++i) {
    const Opponent& opponent = view.beliefs.opponents[i];
    consider(opponent.position, [&] { return view.believes(opponent); });
  }
  for (int i = 0; i + 1 < players; ++i) {
    const Mate& mate = view.beliefs.mates[i];
    consider(mate.pose.position, [&] { return view.believes(mate, ticks(kMateMemory)); });
  }
  if (!found) return target;
  return round_circle(view, turned_back(nearest, view.facing), radius, target, view.mind.search_side);
}

motion::Command walk_in_robot(const View& view, Vec2 target, float heading, float gain) {
  return walk_straight(round_robots(view, target), heading, gain);
}

motion::Command turn_to(const View& view, Vec2 way) {
  motion::Command command;
  if (std::abs(way.y) < kNearlyThere * way.x) return command;
  const float angle = angle_of(way);
  command.body = motion::Command::Body::walk_speed;
  command.turn = clamp(2 * angle, -view.around.motion->walk.turn_rate, view.around.motion->walk.turn_rate);
  return command;
}

motion::Command walk_to_place(const View& view, Vec2 place, Vec2 face, float gain) {
  const Vec2 target = view.to_robot(place);
  const Vec2 facing = turned_back(face, view.facing);
  const float near = view.settings.habits.walk_tolerance;
  if (squared_length(target) < near * near) return turn_to(view, facing);
  return walk_in_robot(view, target, angle_of(facing), gain);
}

}  // namespace sim::agent
