#include <cmath>

#include "sim/world/contact.h"

namespace sim {

namespace {

// [m] nearer than this to each other, two robots touch
constexpr float kTouch = 0.01f;
// [m] overlaps up to this are left
constexpr float kTolerance = 0.0005f;
// a heap of all robots needs about fifty
constexpr int kMostPasses = 500;
// displacements are summed as whole numbers of this unit [1/m]: their sum does not depend on the order
constexpr float kUnits = 0x1p24f;

/// Who is on the field, packed: most of the time it takes a look to see that nobody is near anybody.
struct Circles {
  int count = 0;
  float x[kMaxRobots];
  float y[kMaxRobots];
  float radius[kMaxRobots];
  std::uint8_t robot[kMaxRobots];
};

struct Shifts {
  std::int32_t x[kMaxRobots] = {};
  std::int32_t y[kMaxRobots] = {};
  float worst = 0;  // [m] the greatest overlap

  void add(int i, Vec2 shift) {
    x[i] += static_cast<std::int32_t>(shift.x * kUnits);
    y[i] += static_cast<std::int32_t>(shift.y * kUnits);
  }
};

Circles circles_of(const ContactModel& contact, World& world) {
  Circles circles;
  for_each_robot(world.players, [&](int robot) {
    const Body& body = world.bodies[robot];
    if (body.doing == Body::Doing::removed) return;
    const bool lies = body.doing == Body::Doing::fallen || body.doing == Body::Doing::getting_up;
    const int i = circles.count++;
    circles.x[i] = body.position.x;
    circles.y[i] = body.position.y;
    circles.radius[i] = lies ? contact.lying_radius : contact.robot_radius;
    circles.robot[i] = static_cast<std::uint8_t>(robot);
  });
  return circles;
}

/// From the nearest post to the circle, in the quarter of the field where x and y are positive.
Vec2 from_post(const field::Field& field, const Circles& circles, int i) {
  return {std::fabs(circles.x[i]) - 0.5f * field.length, std::fabs(circles.y[i]) - 0.5f * field.goal_width};
}

bool anything_near(const field::Field& field, float official_radius, Vec2 official, const Circles& circles) {
  bool near = false;
  for (int i = 0; i < circles.count; ++i) {
    for (int j = i + 1; j < circles.count; ++j) {
      const Vec2 apart{circles.x[j] - circles.x[i], circles.y[j] - circles.y[i]};
      const float reach = circles.radius[i] + circles.radius[j] + kTouch;
      near |= squared_length(apart) < reach * reach;
    }
    const float post_reach = circles.radius[i] + field.post_radius;
    near |= squared_length(from_post(field, circles, i)) < post_reach * post_reach;
    const float official_reach = circles.radius[i] + official_radius;
    near |= squared_length(Vec2{circles.x[i], circles.y[i]} - official) < official_reach * official_reach;
  }
  return near;
}

/// It walks, and within 60° of where the other one is.
bool runs_into(const Body& body, Vec2 other) {
  const Vec2 velocity = turned(body.velocity, body.facing), to_other = other - body.position;
  const float towards = dot(velocity, to_other);
  return towards > 0 && towards * towards > 0.25f * squared_length(velocity) * squared_length(to_other);
}

void count_touches(const Circles& circles, World& world) {
  bool touching[kMaxRobots] = {}, pushing[kMaxRobots] = {};
  for (int i = 0; i < circles.count; ++i) {
    for (int j = i + 1; j < circles.count; ++j) {
      const Vec2 apart{circles.x[j] - circles.x[i], circles.y[j] - circles.y[i]};
      const float reach = circles.radius[i] + circles.radius[j] + kTouch;
      if (squared_length(apart) >= reach * reach) continue;
      const Body &first = world.bodies[circles.robot[i]], &second = world.bodies[circles.robot[j]];
      touching[i] = touching[j] = true;
      pushing[i] |= runs_into(first, second.position);
      pushing[j] |= runs_into(second, first.position);
    }
  }

  // `pushing` counts fifths of a second, that is every sixth tick
  const bool counts = world.tick % 6 == 0;
  for (int i = 0; i < circles.count; ++i) {
    Body& body = world.bodies[circles.robot[i]];
    body.touching = !touching[i] ? 0 : body.touching == 255 ? 255 : static_cast<std::uint8_t>(body.touching + 1);
    if (!pushing[i])
      body.pushing = 0;
    else if (counts && body.pushing < 255)
      ++body.pushing;
  }
}

void part_from_robots(const Circles& circles, Shifts& shifts) {
  for (int i = 0; i < circles.count; ++i) {
    for (int j = i + 1; j < circles.count; ++j) {
      const Vec2 apart{circles.x[j] - circles.x[i], circles.y[j] - circles.y[i]};
      const float reach = circles.radius[i] + circles.radius[j];
      const float squared = squared_length(apart);
      if (squared >= reach * reach) continue;
      const float gap = std::sqrt(squared);
      const Vec2 away = gap > 0 ? (1 / gap) * apart : Vec2{1, 0};
      const Vec2 shift = (0.5f * (reach - gap)) * away;
      shifts.worst = std::fmax(shifts.worst, reach - gap);
      shifts.add(i, -shift);
      shifts.add(j, shift);
    }
  }
}

/// `apart` leads from something that does not move to circle i.
Vec2 shift_away(Vec2 apart, float reach, Vec2 otherwise, Shifts& shifts) {
  const float squared = squared_length(apart);
  if (squared >= reach * reach) return {};
  const float gap = std::sqrt(squared);
  shifts.worst = std::fmax(shifts.worst, reach - gap);
  return (reach - gap) * (gap > 0 ? (1 / gap) * apart : otherwise);
}

void part_from_things(const field::Field& field, float official_radius, Vec2 official, const Circles& circles,
                      Shifts& shifts) {
  for (int i = 0; i < circles.count; ++i) {
    const Vec2 folded =
        shift_away(from_post(field, circles, i), circles.radius[i] + field.post_radius, {-1, 0}, shifts);
    shifts.add(i, {std::copysign(1.f, circles.x[i]) * folded.x, std::copysign(1.f, circles.y[i]) * folded.y});
    shifts.add(i, shift_away(Vec2{circles.x[i], circles.y[i]} - official, circles.radius[i] + official_radius, {1, 0},
                             shifts));
  }
}

}  // namespace

void keep_bodies_apart(const field::Field& field, const ContactModel& contact, World& world) {
  Circles circles = circles_of(contact, world);
  const Vec2 official = world.official.position;
  if (!anything_near(field, contact.official_radius, official, circles)) {
    for (int i = 0; i < circles.count; ++i) {
      Body& body = world.bodies[circles.robot[i]];
      body.touching = body.pushing = 0;
    }
    return;
  }
  count_touches(circles, world);

  // everybody moves at once, by what the same places of all demand, until nothing is left to part
  for (int pass = 0; pass < kMostPasses; ++pass) {
    Shifts shifts;
    part_from_robots(circles, shifts);
    part_from_things(field, contact.official_radius, official, circles, shifts);
    if (shifts.worst <= kTolerance) break;
    for (int i = 0; i < circles.count; ++i) {
      circles.x[i] += static_cast<float>(shifts.x[i]) * (1 / kUnits);
      circles.y[i] += static_cast<float>(shifts.y[i]) * (1 / kUnits);
    }
  }
  for (int i = 0; i < circles.count; ++i) world.bodies[circles.robot[i]].position = {circles.x[i], circles.y[i]};
}

}  // namespace sim
