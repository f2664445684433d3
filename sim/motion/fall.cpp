#include "sim/motion/fall.h"

#include <algorithm>

#include "sim/motion/batch.h"
#include "sim/motion/fall_lanes.h"

namespace sim::motion {
namespace {

/// Returns the falls of this robot: its servos are the same in the whole game.
const ServoClass& class_of(const FallTable& table, RandomKey key, int robot) {
  const auto words = draw(key, static_cast<std::uint32_t>(robot), Draw::servos, 0);
  return uniform(words[0]) < table.collisions.soft ? table.soft : table.stiff;
}

/// Returns the rate of falls by the table [1/min]. Not inline, because few models have a table.
[[gnu::noinline]] float rate_of(const FallTable& table, const World& world, int robot) {
  const Body& body = world.bodies[robot];
  const FallRates& rates = class_of(table, world.key, robot).rates;
  const bool walks = body.doing == Body::Doing::walking, shoved = body.touching > 0;
  const Manner manner = walks ? manner_of(body.velocity, body.turn_rate) : Manner::standing;
  const float alone = rates.per_minute[static_cast<int>(manner)];
  return !shoved ? alone : std::max(alone, walks ? rates.shoved_walking : rates.shoved_standing);
}

/// Returns the rate of falls of an upright body [1/s]; 0 for others.
float rate_of(const Falls& falls, const World& world, int robot) {
  const Body& body = world.bodies[robot];
  if (body.doing >= Body::Doing::fallen) return 0;
  if (falls.table.given) return rate_of(falls.table, world, robot) / 60;
  const float walking = body.doing == Body::Doing::walking ? falls.per_minute_walking / 60 : 0;
  return body.touching > 0 ? walking + falls.per_second_touching : walking;
}

void fall(Tick now, Body& body) {
  body.doing = Body::Doing::fallen;
  body.since = now;
  body.velocity = {};
  body.turn_rate = 0;
}

/// A robot that falls at some rate.
struct Faller {
  const Mover* mover;
  float rate;  // [1/s] > 0

  Body& body() const { return mover->world->bodies[mover->robot]; }
};

void perhaps_fall_alone(const Faller& faller) {
  const auto& [mover, rate] = faller;
  const Tick now = mover->world->tick;
  const auto words = draw(mover->world->key, static_cast<std::uint32_t>(mover->robot), Draw::fall, now);
  if (falls_by(words[0], rate, static_cast<float>(mover->steps))) fall(now, faller.body());
}

/// Lets up to kLanes bodies fall, perhaps.
void perhaps_fall_together(std::span<const Faller> fallers) {
  FallLanes lanes;
  if (fallers.size() < kLanes) lanes = {};
  for (int i = 0; const auto& [mover, rate] : fallers) {
    lanes.draws.set(i, mover->world->key, mover->robot, mover->world->tick);
    lanes.rate[i] = rate;
    lanes.ticks[i] = static_cast<float>(mover->steps);
    ++i;
  }
  in_lanes<draw_falls>(lanes);
  for (int i = 0; const Faller& faller : fallers)
    if (lanes.falls[i++] != 0) fall(faller.mover->world->tick, faller.body());
}

}  // namespace

void perhaps_fall(const MotionParams& params, const Mover& mover) {
  const float rate = rate_of(params.model.falls, *mover.world, mover.robot);
  if (rate > 0) perhaps_fall_alone({&mover, rate});
}

void perhaps_fall(const MotionParams& params, std::span<const Mover> movers) {
  const Falls& falls = params.model.falls;
  auto batch = batch_of<Faller>([](std::span<Faller> some) {
    if (worth_lanes(some.size()))
      perhaps_fall_together(some);
    else
      for (const Faller& faller : some) perhaps_fall_alone(faller);
    return std::size_t{0};
  });
  for (const Mover& mover : movers)
    if (const float rate = rate_of(falls, *mover.world, mover.robot); rate > 0) batch.add({&mover, rate});
  batch.finish();
}

void topple(const MotionParams& params, Vec2 closing, int robot, World& world) {
  const FallTable& table = params.model.falls.table;
  Body& body = world.bodies[robot];
  if (!params.effects.falls || !table.given || closing == Vec2{} || body.doing >= Body::Doing::fallen) return;
  const ServoClass& own = class_of(table, world.key, robot);
  const Toppling& toppling = body.doing == Body::Doing::walking ? own.walking : own.standing;
  const auto words = draw(world.key, static_cast<std::uint32_t>(robot), Draw::collision, world.tick);
  if (uniform(words[0]) < toppling.probability(table.collisions.impulse(closing))) fall(world.tick, body);
}

Tick lie(const MotionParams& params, int robot, Tick now, Tick left, World& world) {
  Body& body = world.bodies[robot];
  const Falls& falls = params.model.falls;

  // nothing changes within these ticks
  const bool fallen = body.doing == Body::Doing::fallen;
  const Tick duration = std::max<Tick>(1, ticks(fallen ? falls.lying : falls.getting_up));
  const Tick elapsed = std::min(now - body.since, duration - 1);
  if (elapsed + left < duration) return left;

  const Tick used = duration - elapsed;
  body.since = now + used;
  if (fallen) {
    body.doing = Body::Doing::getting_up;
    return used;
  }
  const auto words = draw(world.key, static_cast<std::uint32_t>(robot), Draw::get_up, body.since);
  body.doing = uniform(words[0]) < falls.failure ? Body::Doing::fallen : Body::Doing::standing;
  return used;
}

}  // namespace sim::motion
