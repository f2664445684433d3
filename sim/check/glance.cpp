#include "sim/check/glance.h"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <limits>

namespace sim::check {
namespace {

using Kind = referee::Event::Kind;

constexpr Tick kSameTouch = ticks(0.5f);
constexpr Tick kFreshSight = ticks(1.f);

template <Side Whose>
bool touches(const Glance& glance) {
  return glance.toucher != kNobody && side_of(glance.toucher) == Whose;
}

template <Side Whose>
bool passes(const Glance& glance) {
  return touches<Whose>(glance) && glance.before != kNobody && glance.before != glance.toucher &&
         side_of(glance.before) == Whose;
}

template <Side Whose>
bool shoots(const Glance& glance) {
  return glance.shots[static_cast<int>(Whose)] > 0;
}

template <class Is>
bool any_event(const Glance& glance, Is&& is) {
  return std::ranges::any_of(*glance.events, is);
}

template <Side Whose>
bool scores(const Glance& glance) {
  return any_event(glance, [](const referee::Event& event) { return event.kind == Kind::goal && event.side == Whose; });
}

template <Side Whose>
bool is_penalised(const Glance& glance) {
  return any_event(glance, [](const referee::Event& event) {
    return event.kind >= Kind::pushing && event.kind <= Kind::illegal_position && event.robot != kNobody &&
           event.side == Whose;
  });
}

bool leaves(const Glance& glance) {
  return any_event(glance, [](const referee::Event& event) { return referee::is_out(event.kind); });
}

/// Returns the point as the home side sees it [m, team_field].
Vec2 seen_by_us(const Glance& glance, Vec2 in_field) { return attack_sign(glance.now->world, Side::home) * in_field; }

template <Side Whose>
float goals(const Glance& glance) {
  const int index = static_cast<int>(Whose);
  return static_cast<float>(glance.now->book.score[index] - glance.start->book.score[index]);
}

template <Side Whose, class See>
void for_each_on_field(const Glance& glance, See&& see) {
  const World& world = glance.now->world;
  for_each_robot(world.players, [&](int robot) {
    const Body& body = world.bodies[robot];
    if (side_of(robot) == Whose && on_field(body)) see(body);
  });
}

template <Side Whose>
float players(const Glance& glance) {
  float count = 0;
  for_each_on_field<Whose>(glance, [&](const Body&) { count += 1; });
  return count;
}

template <Side Whose>
float ball_distance(const Glance& glance) {
  float nearest = std::numeric_limits<float>::quiet_NaN();
  for_each_on_field<Whose>(glance, [&](const Body& body) {
    const float metres = distance(body.position, glance.now->world.ball.position);
    if (!(nearest <= metres)) nearest = metres;
  });
  return nearest;
}

/// Returns the least distance [m] between the ball and the place where a robot of the side saw it in the last second.
template <Side Whose>
float ball_error(const Glance& glance) {
  const World& world = glance.now->world;
  float least = std::numeric_limits<float>::quiet_NaN();
  for_each_robot(world.players, [&](int robot) {
    const Body& body = world.bodies[robot];
    const agent::Ball& seen = glance.now->robots[robot].beliefs.ball;
    const bool is_fresh = seen.seen != kNever && world.tick - seen.seen <= kFreshSight;
    if (side_of(robot) != Whose || !on_field(body) || !is_fresh) return;
    const float error = distance(turned_back(world.ball.position - body.position, body.facing), seen.position);
    if (!(least <= error)) least = error;
  });
  return least;
}

constexpr Happening kHappenings[] = {
    {"our touch", "one of our robots touches the ball anew", touches<Side::home>},
    {"their touch", "one of their robots touches the ball anew", touches<Side::away>},
    {"our pass", "one of our robots touches the ball, and the touch before was that of another one of ours",
     passes<Side::home>},
    {"their pass", "likewise of their robots", passes<Side::away>},
    {"our shot", "one of our kicks would roll into their goal", shoots<Side::home>},
    {"their shot", "one of their kicks would roll into our goal", shoots<Side::away>},
    {"our goal", "we score", scores<Side::home>},
    {"their goal", "they score", scores<Side::away>},
    {"our penalty", "the referee removes one of our robots", is_penalised<Side::home>},
    {"their penalty", "the referee removes one of their robots", is_penalised<Side::away>},
    {"ball out", "the ball leaves the field, and no goal is scored", leaves},
};

constexpr Quantity kQuantities[] = {
    {"time", "s", 0, 3600, "time since the start", [](const Glance& glance) { return glance.time(); }},
    {"ball_x", "m", -15, 15, "x of the ball, > 0 in their half",
     [](const Glance& glance) { return seen_by_us(glance, glance.now->world.ball.position).x; }},
    {"ball_y", "m", -10, 10, "y of the ball, > 0 to the left",
     [](const Glance& glance) { return seen_by_us(glance, glance.now->world.ball.position).y; }},
    {"ball_speed", "m/s", 0, 20, "speed of the ball",
     [](const Glance& glance) { return length(glance.now->world.ball.velocity); }},
    {"our_ball_distance", "m", 0, 30, "distance of our nearest robot from the ball", ball_distance<Side::home>},
    {"their_ball_distance", "m", 0, 30, "distance of their nearest robot from the ball", ball_distance<Side::away>},
    {"our_ball_error", "m", 0, 30, "least distance of the ball from where one of ours saw it in the last second",
     ball_error<Side::home>},
    {"their_ball_error", "m", 0, 30, "likewise of their robots", ball_error<Side::away>},
    {"our_goals", "goals", 0, 255, "our goals since the start", goals<Side::home>},
    {"their_goals", "goals", 0, 255, "their goals since the start", goals<Side::away>},
    {"our_players", "robots", 0, 7, "our robots on the field", players<Side::home>},
    {"their_players", "robots", 0, 7, "their robots on the field", players<Side::away>},
};

}  // namespace

int happening_count() { return static_cast<int>(std::size(kHappenings)); }
int quantity_count() { return static_cast<int>(std::size(kQuantities)); }
const Happening& happening(int index) { return kHappenings[index]; }
const Quantity& quantity(int index) { return kQuantities[index]; }

Glance Observer::look(const State& now, const referee::Events& events) {
  Glance glance{.start = &start_, .now = &now, .events = &events};
  const World& world = now.world;
  if (world.touched != kNobody) {
    const bool is_new = world.touched != toucher_ || world.tick - touched_ > kSameTouch;
    if (is_new) glance.toucher = world.touched, glance.before = toucher_;
    toucher_ = world.touched;
    touched_ = world.tick;
  }
  for (const int side : {0, 1}) {
    const int last = shots_[side] < 0 ? start_.counts.shots[side] : shots_[side];
    shots_[side] = now.counts.shots[side];
    glance.shots[side] = shots_[side] - last;
  }
  return glance;
}

}  // namespace sim::check
