#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <utility>

#include "sim/world/contact.h"

namespace sim {

namespace {

constexpr float kTouch = 0.01f;        // [m] gap below which two robots touch
constexpr float kTolerance = 0.0005f;  // [m] overlaps up to this remain
// [m] larger gaps are not tested again until a robot has moved by half of this
constexpr float kMargin = 0.1f;
// A heap of all robots needs some dozens of passes, a robot wedged between a post and the referee some hundreds.
constexpr int kMostPasses = 2000;
// [1/m] Shifts are summed as whole numbers of 1 / kUnits, so that the sum does not depend on the order.
constexpr float kUnits = 0x1p24f;

/// The robots on the field as circles, which the passes shift.
struct Circles {
  int count = 0;
  float x[kMaxRobots];
  float y[kMaxRobots];
  float radius[kMaxRobots];
  std::uint8_t robot[kMaxRobots];

  Vec2 middle(int i) const { return {x[i], y[i]}; }
};

/// The things that do not give way: posts and the walking referee.
struct Things {
  Vec2 post;  // the one with positive x and y
  float post_radius;
  const Official& official;
  float official_radius;

  Vec2 from_post(Vec2 middle) const { return {std::fabs(middle.x) - post.x, std::fabs(middle.y) - post.y}; }
};

/// The pairs of near robots, and the robots near things.
struct Neighbours {
  int pairs = 0;
  int at_things = 0;
  std::uint8_t first[kMaxRobots * (kMaxRobots - 1) / 2];
  std::uint8_t second[kMaxRobots * (kMaxRobots - 1) / 2];
  std::uint8_t at_thing[kMaxRobots];
};

/// The sum of all shifts of one pass.
struct Shifts {
  float worst = 0;  // [m] greatest overlap
  std::int32_t x[kMaxRobots] = {};
  std::int32_t y[kMaxRobots] = {};

  void add(int i, Vec2 shift) {
    x[i] += static_cast<std::int32_t>(shift.x * kUnits);
    y[i] += static_cast<std::int32_t>(shift.y * kUnits);
  }
};

Circles circles_of(const ContactModel& contact, const Crowd& crowd, const World& world) {
  Circles circles;
  circles.count = crowd.count;
  for (int i = 0; i < crowd.count; ++i) {
    circles.x[i] = crowd.x[i];
    circles.y[i] = crowd.y[i];
    circles.radius[i] = lies(world.bodies[crowd.robot[i]]) ? contact.lying_radius : contact.robot_radius;
    circles.robot[i] = crowd.robot[i];
  }
  return circles;
}

/// The squared distances of middles [m²] below which a gap may be less than `margin`, if all
/// robots were as large as the largest.
struct Limits {
  float robots;
  float post;
  float official;
};

Limits limits_of(const Things& things, float largest, float margin) {
  const auto squared = [](float reach) { return reach * reach; };
  return {squared(2 * largest + margin), squared(largest + things.post_radius + margin),
          squared(largest + things.official_radius + margin)};
}

/// Reports whether any robot may touch anything. It is fast: it tests a block at a time.
bool anything_near(const Things& things, const Crowd& crowd, float largest) {
  const Limits limits = limits_of(things, largest, kTouch);
  std::uint32_t hits[Crowd::kBlock] = {};
  const auto count_near = [&](int block, auto&& is_near) {
    for (int lane = 0; lane < Crowd::kBlock; ++lane) hits[lane] += is_near(crowd.middle(block + lane)) ? 1u : 0u;
  };
  for (int block = 0; block < crowd.count; block += Crowd::kBlock) {
    count_near(block, [&](Vec2 middle) { return squared_length(things.from_post(middle)) < limits.post; });
    const int end = std::min(block + Crowd::kBlock, crowd.count);
    for (int i = 0; i < end; ++i)
      count_near(block,
                 [&, own = crowd.middle(i)](Vec2 middle) { return squared_length(middle - own) < limits.robots; });
  }
  if (is_there(things.official))
    for (int block = 0; block < crowd.count; block += Crowd::kBlock)
      count_near(block,
                 [&](Vec2 middle) { return squared_length(middle - things.official.position) < limits.official; });
  // each robot counts once as near itself
  return hits[0] + hits[1] + hits[2] + hits[3] > static_cast<std::uint32_t>(crowd.count);
}

Neighbours neighbours_of(const Things& things, const Circles& circles, float largest) {
  const Limits limits = limits_of(things, largest, kMargin);
  Neighbours near;
  for (int i = 0; i < circles.count; ++i) {
    const Vec2 middle = circles.middle(i);
    for (int j = i + 1; j < circles.count; ++j) {
      if (squared_length(circles.middle(j) - middle) >= limits.robots) continue;
      near.first[near.pairs] = static_cast<std::uint8_t>(i);
      near.second[near.pairs++] = static_cast<std::uint8_t>(j);
    }
    if (squared_length(things.from_post(middle)) < limits.post ||
        squared_length(middle - things.official.position) < limits.official)
      near.at_thing[near.at_things++] = static_cast<std::uint8_t>(i);
  }
  return near;
}

/// Reports whether a body walks in a direction within 60° of the other one.
bool runs_into(const Body& body, const Body& other) {
  const Vec2 to_other = turned_back(other.position - body.position, body.facing);
  const float towards = dot(body.velocity, to_other);
  return towards > 0 && towards * towards > 0.25f * squared_length(body.velocity) * squared_length(to_other);
}

void count_touches(const Circles& circles, const Neighbours& near, World& world) {
  bool touching[kMaxRobots] = {}, pushing[kMaxRobots] = {};
  for (int pair = 0; pair < near.pairs; ++pair) {
    const int i = near.first[pair], j = near.second[pair];
    const float reach = circles.radius[i] + circles.radius[j] + kTouch;
    if (squared_length(circles.middle(j) - circles.middle(i)) >= reach * reach) continue;
    const Body &first = world.bodies[circles.robot[i]], &second = world.bodies[circles.robot[j]];
    touching[i] = touching[j] = true;
    if (runs_into(first, second)) pushing[i] = true;
    if (runs_into(second, first)) pushing[j] = true;
  }

  // `pushing` counts in units of several ticks
  const bool counts = world.tick % kPushingUnit == 0;
  for (int i = 0; i < circles.count; ++i) {
    Body& body = world.bodies[circles.robot[i]];
    body.touching = touching[i] ? static_cast<std::uint8_t>(std::min(body.touching + 1, 255)) : std::uint8_t{0};
    if (!pushing[i])
      body.pushing = 0;
    else if (counts)
      body.pushing = static_cast<std::uint8_t>(std::min(body.pushing + 1, 255));
  }
}

/// Returns the shift that is missing until `apart`, the vector to a circle's middle, is `reach` long. `otherwise` is
/// its direction when `apart` is zero.
Vec2 missing(Vec2 apart, float reach, Vec2 otherwise, Shifts& shifts) {
  const float squared = squared_length(apart);
  if (squared >= reach * reach) return {};
  const float gap = std::sqrt(squared);
  shifts.worst = std::max(shifts.worst, reach - gap);
  return (reach - gap) * (gap > 0 ? (1 / gap) * apart : otherwise);
}

/// Returns the shift that each robot needs, given the places of all.
Shifts shifts_of(const Things& things, const Circles& circles, const Neighbours& near) {
  Shifts shifts;
  for (int pair = 0; pair < near.pairs; ++pair) {
    const int i = near.first[pair], j = near.second[pair];
    const Vec2 half =
        0.5f * missing(circles.middle(j) - circles.middle(i), circles.radius[i] + circles.radius[j], {1, 0}, shifts);
    shifts.add(i, -half);
    shifts.add(j, half);
  }
  for (int index = 0; index < near.at_things; ++index) {
    const int i = near.at_thing[index];
    const Vec2 middle = circles.middle(i);
    const Vec2 folded = missing(things.from_post(middle), circles.radius[i] + things.post_radius, {-1, 0}, shifts);
    shifts.add(i, {std::copysign(1.f, middle.x) * folded.x, std::copysign(1.f, middle.y) * folded.y});
    shifts.add(i,
               missing(middle - things.official.position, circles.radius[i] + things.official_radius, {1, 0}, shifts));
  }
  return shifts;
}

/// Parts overlapping robots, when the fast test found some near each other. Not inline, because it is rare.
[[gnu::noinline]] void part(const ContactModel& contact, const Things& things, float largest, Crowd& crowd,
                            World& world) {
  Circles circles = circles_of(contact, crowd, world);
  Neighbours near = neighbours_of(things, circles, largest);
  count_touches(circles, near, world);

  // shift all robots together, pass after pass, until no overlap is left
  float moved = 0;
  for (int pass = 0; pass < kMostPasses; ++pass) {
    const Shifts shifts = shifts_of(things, circles, near);
    if (shifts.worst <= kTolerance) break;
    std::int32_t farthest = 0;
    for (int i = 0; i < circles.count; ++i) {
      circles.x[i] += static_cast<float>(shifts.x[i]) * (1 / kUnits);
      circles.y[i] += static_cast<float>(shifts.y[i]) * (1 / kUnits);
      farthest = std::max(farthest, std::abs(shifts.x[i]) + std::abs(shifts.y[i]));
    }
    moved += static_cast<float>(farthest) * (1 / kUnits);
    if (moved <= kMargin / 2) continue;
    near = neighbours_of(things, circles, largest);
    moved = 0;
  }
  for (int i = 0; i < circles.count; ++i) {
    crowd.x[i] = circles.x[i];
    crowd.y[i] = circles.y[i];
    world.bodies[circles.robot[i]].position = circles.middle(i);
  }
}

}  // namespace

void keep_bodies_apart(const field::Field& field, const ContactModel& contact, Crowd& crowd, World& world) {
  const Things things{field::post_of(field, 0), field.post_radius, world.official, contact.official_radius};
  const float largest =
      crowd.somebody_lies ? std::max(contact.lying_radius, contact.robot_radius) : contact.robot_radius;
  const bool counted = std::exchange(world.crowded, anything_near(things, crowd, largest));
  if (world.crowded) return part(contact, things, largest, crowd, world);
  if (!counted) return;
  for (int i = 0; i < crowd.count; ++i) {
    Body& body = world.bodies[crowd.robot[i]];
    body.touching = body.pushing = 0;
  }
}

}  // namespace sim
