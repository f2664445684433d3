#include <algorithm>
#include <bit>
#include <cmath>
#include <cstdlib>
#include <utility>

#include "sim/world/contact.h"
#include "sim/world/touch.h"

namespace sim {

namespace {

constexpr float kTolerance = 0.0005f;  // [m] overlaps up to this remain
// [m] larger gaps are not tested again until a robot has moved by half of this
constexpr float kMargin = 0.1f;
// A heap of all robots needs some dozens of passes, a robot wedged between a post and the referee some hundreds.
constexpr int kMostPasses = 2000;
// [1/m] Shifts are summed as whole numbers of 1 / kUnits, so that the sum does not depend on the order.
constexpr float kUnits = 0x1p24f;

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

  void add(int i, int j) {
    first[pairs] = static_cast<std::uint8_t>(i);
    second[pairs++] = static_cast<std::uint8_t>(j);
  }
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
  Vec2 of(int i) const { return {static_cast<float>(x[i]) * (1 / kUnits), static_cast<float>(y[i]) * (1 / kUnits)}; }
};

/// The radii of all robots [m], by their index in the crowd.
struct Radii {
  float of[kMaxRobots];
};

Radii radii_of(const ContactModel& contact, const Crowd& crowd, const World& world) {
  Radii radii;
  for (int i = 0; i < crowd.count; ++i) radii.of[i] = radius_of(contact, world.bodies[crowd.robot(i)]);
  return radii;
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

/// Returns those whose gap may be less than the margin of the limits. It is fast, because it runs in most ticks: it tests
/// each robot with the one that is some places further on, a block at a time.
Neighbours neighbours_of(const Things& things, const Crowd& crowd, const Limits& limits) {
  std::uint32_t near[Crowd::kRoom];  // bit 0: a thing is near; bit n: the robot n places further on is
  std::uint32_t anybody[Crowd::kBlock] = {};
  for (int block = 0; block < crowd.count; block += Crowd::kBlock) {
    std::uint32_t bits[Crowd::kBlock];
    const auto each_lane = [&](auto&& see) {
      for (int lane = 0; lane < Crowd::kBlock; ++lane) see(lane, crowd.middle(block + lane));
    };
    each_lane(
        [&](int lane, Vec2 middle) { bits[lane] = squared_length(things.from_post(middle)) < limits.post ? 1u : 0u; });
    if (is_there(things.official))
      each_lane([&](int lane, Vec2 middle) {
        bits[lane] |= squared_length(middle - things.official.position) < limits.official ? 1u : 0u;
      });
    for (int further = 1; 2 * further <= crowd.count; ++further)
      each_lane([&](int lane, Vec2 middle) {
        const Vec2 apart = crowd.middle(block + lane + further) - middle;
        bits[lane] |= (squared_length(apart) < limits.robots ? 1u : 0u) << further;
      });
    each_lane([&](int lane, Vec2) { near[block + lane] = bits[lane], anybody[lane] |= bits[lane]; });
  }

  Neighbours neighbours;
  if ((anybody[0] | anybody[1] | anybody[2] | anybody[3]) == 0) return neighbours;
  for (int i = 0; i < crowd.count; ++i)
    for (std::uint32_t bits = near[i]; bits != 0; bits &= bits - 1) {
      const int further = std::countr_zero(bits);
      if (further == 0)
        neighbours.at_thing[neighbours.at_things++] = static_cast<std::uint8_t>(i);
      else if (2 * further < crowd.count || i < further)  // those opposite would be found twice
        neighbours.add(i, (i + further) % crowd.count);
    }
  return neighbours;
}

/// Reports whether a body walks in a direction within 60° of the other one.
bool runs_into(const Body& body, const Body& other) {
  const Vec2 to_other = turned_back(other.position - body.position, body.facing);
  const float towards = dot(body.velocity, to_other);
  return towards > 0 && towards * towards > 0.25f * squared_length(body.velocity) * squared_length(to_other);
}

/// Counts on in the bodies that touch another one or run into it, and sets the counts of all others to 0. Reports whether
/// any body has begun to touch another one.
bool count_touches(const ContactModel& contact, const Crowd& crowd, const Neighbours& near, World& world) {
  std::uint32_t touching = 0, pushing = 0;  // one bit per robot of the crowd
  for (int pair = 0; pair < near.pairs; ++pair) {
    const int i = near.first[pair], j = near.second[pair];
    const Body &first = world.bodies[crowd.robot(i)], &second = world.bodies[crowd.robot(j)];
    const float reach = radius_of(contact, first) + radius_of(contact, second) + kTouch;
    if (squared_length(crowd.middle(j) - crowd.middle(i)) >= reach * reach) continue;
    touching |= 1u << i | 1u << j;
    if (runs_into(first, second)) pushing |= 1u << i;
    if (runs_into(second, first)) pushing |= 1u << j;
  }

  // `pushing` counts in units of several ticks
  const bool counts = world.tick % kPushingUnit == 0;
  const auto one_more = [](std::uint8_t count) { return static_cast<std::uint8_t>(std::min(count + 1, 255)); };
  std::uint32_t bit = 1;
  bool met = false;
  for_each_robot(world.players, [&](int robot) {
    Body& body = world.bodies[robot];
    const bool touches = (touching & bit) != 0, pushes = (pushing & bit) != 0;
    bit <<= 1;
    if (!touches) {
      body.touching = body.pushing = 0;
      return;
    }
    met |= body.touching == 0;
    body.touching = one_more(body.touching);
    body.pushing = !pushes ? std::uint8_t{0} : counts ? one_more(body.pushing) : body.pushing;
  });
  return met;
}

/// Reports whether any of these overlap by more than kTolerance.
bool overlap(const ContactModel& contact, const Things& things, const Crowd& crowd, const Neighbours& near,
             const World& world) {
  const auto radius = [&](int i) { return radius_of(contact, world.bodies[crowd.robot(i)]); };
  const auto is_deep = [](Vec2 apart, float reach) { return reach - length(apart) > kTolerance; };
  for (int pair = 0; pair < near.pairs; ++pair) {
    const int i = near.first[pair], j = near.second[pair];
    if (is_deep(crowd.middle(j) - crowd.middle(i), radius(i) + radius(j))) return true;
  }
  for (int index = 0; index < near.at_things; ++index) {
    const int i = near.at_thing[index];
    const Vec2 middle = crowd.middle(i);
    if (is_deep(things.from_post(middle), radius(i) + things.post_radius)) return true;
    if (is_deep(middle - things.official.position, radius(i) + things.official_radius)) return true;
  }
  return false;
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
Shifts shifts_of(const Things& things, const Crowd& crowd, const Radii& radii, const Neighbours& near) {
  Shifts shifts;
  for (int pair = 0; pair < near.pairs; ++pair) {
    const int i = near.first[pair], j = near.second[pair];
    const Vec2 half = 0.5f * missing(crowd.middle(j) - crowd.middle(i), radii.of[i] + radii.of[j], {1, 0}, shifts);
    shifts.add(i, -half);
    shifts.add(j, half);
  }
  for (int index = 0; index < near.at_things; ++index) {
    const int i = near.at_thing[index];
    const Vec2 middle = crowd.middle(i);
    const Vec2 folded = missing(things.from_post(middle), radii.of[i] + things.post_radius, {-1, 0}, shifts);
    shifts.add(i, {std::copysign(1.f, middle.x) * folded.x, std::copysign(1.f, middle.y) * folded.y});
    shifts.add(i, missing(middle - things.official.position, radii.of[i] + things.official_radius, {1, 0}, shifts));
  }
  return shifts;
}

/// Parts robots of which some overlap. Not inline, because it is rare.
[[gnu::noinline]] void part(const ContactModel& contact, const Things& things, float largest, Crowd& crowd,
                            World& world) {
  const Radii radii = radii_of(contact, crowd, world);
  const Limits limits = limits_of(things, largest, kMargin);
  Neighbours near = neighbours_of(things, crowd, limits);

  // shift all robots together, pass after pass, until no overlap is left
  float moved = 0;
  for (int pass = 0; pass < kMostPasses; ++pass) {
    const Shifts shifts = shifts_of(things, crowd, radii, near);
    if (shifts.worst <= kTolerance) break;
    std::int32_t farthest = 0;
    for (int i = 0; i < crowd.count; ++i) {
      crowd.place(i, crowd.middle(i) + shifts.of(i));
      farthest = std::max(farthest, std::abs(shifts.x[i]) + std::abs(shifts.y[i]));
    }
    moved += static_cast<float>(farthest) * (1 / kUnits);
    if (moved <= kMargin / 2) continue;
    near = neighbours_of(things, crowd, limits);
    moved = 0;
  }
  for (int i = 0; i < crowd.count; ++i) {
    Body& body = world.bodies[crowd.robot(i)];
    if (on_field(body)) body.position = crowd.middle(i);
  }
}

}  // namespace

bool keep_bodies_apart(const field::Field& field, const ContactModel& contact, Crowd& crowd, World& world) {
  const Things things{field::post_of(field, 0), field.post_radius, world.official, contact.official_radius};
  const float largest =
      crowd.somebody_lies ? std::max(contact.lying_radius, contact.robot_radius) : contact.robot_radius;
  const Limits limits = limits_of(things, largest, kTouch);
  const Neighbours near = neighbours_of(things, crowd, limits);
  const bool counted = std::exchange(world.crowded, near.pairs + near.at_things > 0);
  if (!world.crowded && !counted) return false;
  const bool met = count_touches(contact, crowd, near, world);
  if (overlap(contact, things, crowd, near, world)) part(contact, things, largest, crowd, world);
  return met;
}

}  // namespace sim
