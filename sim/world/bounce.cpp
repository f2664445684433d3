#include <algorithm>
#include <cmath>

#include "sim/world/contact.h"

namespace sim {

namespace {

// After this many rebounds within one tick the ball is stuck between things and stays there until the next tick.
constexpr int kMostRebounds = 4;
constexpr float kLeastOverlap = 1e-5f;  // [m] a smaller overlap does not count

/// A body or a post that the ball can hit.
struct Obstacle {
  Vec2 position;       // [m, field]
  Vec2 velocity;       // [m/s, field]
  float reach;         // [m] from its middle to the middle of a ball that touches it
  float keeps;         // [0..1] share of the speed that the ball keeps
  std::uint8_t robot;  // kNobody: a post
};

/// The obstacles that the ball may meet in this tick: robots, and kNobody for a post.
struct Near {
  int count = 0;
  std::uint8_t list[kMaxRobots + 1];
};

/// The ball on its way through this tick. [field]
struct Moving {
  Vec2 position;
  Vec2 velocity;
};

/// The contact of a ball with an obstacle.
struct Meeting {
  float time = 0;   // [s] from now
  float depth = 0;  // [m²] of a present overlap

  bool before(const Meeting& other) const { return time < other.time || (time == other.time && depth > other.depth); }
};

/// Returns the distance at which a body touches the ball, minus the ball's radius [m].
float touch_radius(const ContactModel& contact, Body::Doing doing) {
  switch (doing) {
    case Body::Doing::squatting: return contact.squatting_radius;
    case Body::Doing::fallen:
    case Body::Doing::getting_up: return contact.lying_radius;
    default: return contact.foot_radius;
  }
}

/// The region in which the ball can meet something in this tick.
struct Way {
  Vec2 whole;   // [m] its displacement
  Vec2 middle;  // [m, field]
  float half;   // [m] upper bound of half its length

  bool within(Vec2 place, float reach) const {
    return squared_length(place - middle) < (reach + half) * (reach + half);
  }
};

/// Returns the ball's way in this tick. |x| + |y| is an upper bound of its length.
Way way_of(const Ball& ball) {
  const Vec2 whole = kTickDuration * ball.velocity;
  return {whole, ball.position - 0.5f * whole, 0.5f * (std::fabs(whole.x) + std::fabs(whole.y))};
}

/// Returns the greatest distance at which the ball may touch a body, whatever the body does [m].
float widest_reach(const BallModel& ball, const ContactModel& contact) {
  return std::max({contact.foot_radius, contact.squatting_radius, contact.lying_radius}) + ball.radius;
}

/// Returns the post in the ball's quarter of the field.
Vec2 nearest_post(const field::Field& field, Vec2 ball) {
  const Vec2 post = field::post_of(field, 0);
  return {std::copysign(post.x, ball.x), std::copysign(post.y, ball.y)};
}

Near near_to(const field::Field& field, const BallModel& ball, const ContactModel& contact, const Crowd& crowd,
             const Way& way) {
  Near near;
  const float farthest = widest_reach(ball, contact);
  if (crowd.anybody_within(way.middle, farthest + way.half))
    for (int i = 0; i < crowd.count; ++i)
      if (way.within(crowd.middle(i), farthest)) near.list[near.count++] = static_cast<std::uint8_t>(crowd.robot(i));
  if (way.within(nearest_post(field, way.middle), field.post_radius + ball.radius)) near.list[near.count++] = kNobody;
  return near;
}

Obstacle obstacle_of(const field::Field& field, const BallModel& ball, const ContactModel& contact, const World& world,
                     const Way& way, std::uint8_t robot) {
  if (robot == kNobody)
    return {nearest_post(field, way.middle), {}, field.post_radius + ball.radius, ball.post_restitution, kNobody};
  const Body& body = world.bodies[robot];
  return {body.position, turned(body.velocity, body.facing), touch_radius(contact, body.doing) + ball.radius,
          ball.robot_restitution, robot};
}

/// Reports whether the ball meets the obstacle within `time` [s], and sets `meeting`.
bool meets(const Moving& ball, const Obstacle& obstacle, float time, Meeting& meeting) {
  const Vec2 offset = ball.position - obstacle.position;
  const float outside = squared_length(offset) - obstacle.reach * obstacle.reach;
  if (outside < -2 * kLeastOverlap * obstacle.reach) {
    meeting = {0, -outside};
    return true;
  }

  // the ball must come nearer, both over ground and relative to the body
  const float nearing = dot(offset, ball.velocity);
  if (nearing >= 0 || dot(offset, ball.velocity - obstacle.velocity) >= 0) return false;
  const float squared_speed = squared_length(ball.velocity);
  const float root = nearing * nearing - squared_speed * outside;
  if (root < 0) return false;
  meeting = {std::fmax(0.f, (-nearing - std::sqrt(root)) / squared_speed), 0};
  return meeting.time <= time;
}

/// Returns the ball just outside the obstacle, thrown back or pushed along.
Moving rebound(Moving ball, const Obstacle& obstacle, const ContactModel& contact, const Effects& effects,
               const World& world) {
  const Vec2 offset = ball.position - obstacle.position;
  const float gap = length(offset);
  const Vec2 away = gap > 0 ? (1 / gap) * offset : Vec2{1, 0};
  ball.position = obstacle.position + obstacle.reach * away;

  // relative to the obstacle, the ball keeps its tangential speed and its normal speed is reversed
  const float own = dot(obstacle.velocity, away);
  const float relative = dot(ball.velocity, away) - own;
  if (relative >= 0) return ball;
  ball.velocity += (-(1 + obstacle.keeps) * relative) * away;

  // a moving foot pushes it in a random direction
  if (own > 0 && effects.push_noise) {
    const auto words = draw(world.key, obstacle.robot, Draw::push_noise, world.tick);
    const float deviation = contact.push_deviation * normals(words[0], words[1])[0];
    ball.velocity = turned(ball.velocity, direction(deviation));
    const float speed = dot(ball.velocity, away);
    if (speed < own) ball.velocity += (own - speed) * away;
  }
  return ball;
}

/// Computes the ball's way again, with its rebounds off obstacles. Not inline, because it is rare.
[[gnu::noinline]] void bounce_off(const field::Field& field, const BallModel& ball, const ContactModel& contact,
                                  const Effects& effects, const Near& near, const Way& way, World& world) {
  const auto obstacle = [&](int i) { return obstacle_of(field, ball, contact, world, way, near.list[i]); };
  Moving moving{world.ball.position - way.whole, world.ball.velocity};
  float left = kTickDuration;
  for (int round = 0; round < kMostRebounds; ++round) {
    // find the first obstacle; of several at the same time the mean effect counts
    Meeting first{left, -1};
    int met[kMaxRobots + 1], count = 0;
    for (int i = 0; i < near.count; ++i) {
      Meeting meeting;
      if (!meets(moving, obstacle(i), left, meeting) || first.before(meeting)) continue;
      if (meeting.before(first)) count = 0;
      first = meeting;
      met[count++] = i;
    }
    if (count == 0) {
      if (round == 0) return;
      moving.position += left * moving.velocity;
      break;
    }

    moving.position += first.time * moving.velocity;
    left -= first.time;
    Moving sum;
    std::uint8_t touched = kNobody;
    for (int i = 0; i < count; ++i) {
      const Moving one = rebound(moving, obstacle(met[i]), contact, effects, world);
      sum.position += one.position;
      sum.velocity += one.velocity;
      const std::uint8_t robot = near.list[met[i]];
      if (robot != kNobody && (touched == kNobody || is_named_before(world, robot, touched))) touched = robot;
    }
    moving.position = (1 / static_cast<float>(count)) * sum.position;
    moving.velocity = (1 / static_cast<float>(count)) * sum.velocity;
    if (touched != kNobody) world.touched = touched;
  }
  world.ball.position = moving.position;
  world.ball.velocity = moving.velocity;
}

/// The robot of each side that pushes the ball, or kNobody.
struct Duel {
  std::uint8_t pusher[2] = {kNobody, kNobody};  // by Side

  bool on() const { return pusher[0] != kNobody && pusher[1] != kNobody; }
};

/// Finds for each side the first robot, in the order of `is_named_before`, that walks towards a ball at its feet.
Duel duel_of(const BallModel& ball, const ContactModel& contact, const Near& near, const World& world) {
  const float reach = contact.foot_radius + ball.radius + contact.duel_gap;
  Duel duel;
  for (int i = 0; i < near.count; ++i) {
    const std::uint8_t robot = near.list[i];
    if (robot == kNobody) continue;
    const Body& body = world.bodies[robot];
    const Vec2 to_ball = world.ball.position - body.position;
    const bool pushes = body.doing == Body::Doing::walking && dot(turned(body.velocity, body.facing), to_ball) > 0;
    if (!pushes || squared_length(to_ball) >= reach * reach) continue;
    std::uint8_t& pusher = duel.pusher[static_cast<int>(side_of(robot))];
    if (pusher == kNobody || is_named_before(world, robot, pusher)) pusher = robot;
  }
  return duel;
}

/// Perhaps lets the ball leave a duel sideways: across the line of both robots, to either side alike.
void squeeze_out(const BallModel& ball, const ContactModel& contact, const Near& near, World& world) {
  const Duel duel = duel_of(ball, contact, near, world);
  if (!duel.on()) return;
  const auto words = draw(world.key, kNobody, Draw::duel, world.tick);
  if (uniform(words[0]) >= contact.duel_rate * kTickDuration) return;

  // from the side that attacks -x to the other one, so that exchanged sides have the same game
  const Vec2 line = world.bodies[duel.pusher[0]].position - world.bodies[duel.pusher[1]].position;
  const float gap = length(line);
  const Vec2 along = gap > 0 ? (world.home_attacks / gap) * line : Vec2{1, 0};
  const float speed = contact.duel_speed * uniform(words[1]);
  world.ball.velocity = ((words[2] & 1) != 0 ? speed : -speed) * Vec2{-along.y, along.x};
  world.touched = is_named_before(world, duel.pusher[0], duel.pusher[1]) ? duel.pusher[0] : duel.pusher[1];
}

}  // namespace

void bounce_ball(const field::Field& field, const BallModel& ball, const ContactModel& contact, const Effects& effects,
                 const Crowd& crowd, World& world) {
  const Way way = way_of(world.ball);
  const Near near = near_to(field, ball, contact, crowd, way);
  if (near.count > 0) bounce_off(field, ball, contact, effects, near, way, world);
  if (near.count > 1 && effects.duels) squeeze_out(ball, contact, near, world);
}

}  // namespace sim
