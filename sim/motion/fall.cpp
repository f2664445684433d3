#include "sim/motion/fall.h"

#include <algorithm>
#include <array>

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

/// How a body that is down gets up.
struct Attempt {
  float lying, getting_up;  // [s]
  float failure;            // [0..1]
};

Attempt attempt_of(const Falls& falls, const World& world, int robot) {
  if (!falls.table.given) return {falls.lying, falls.getting_up, falls.failure};
  const GettingUp& own = class_of(falls.table, world.key, robot).getting_up;
  const Lying lying{world.bodies[robot].kind};
  return {own.lying, own.seconds(lying), own.failure(lying)};
}

/// Returns the rate of falls of an upright body [1/s]; 0 for others.
float rate_of(const Falls& falls, const World& world, int robot) {
  const Body& body = world.bodies[robot];
  if (body.doing >= Body::Doing::fallen) return 0;
  if (falls.table.given) return rate_of(falls.table, world, robot) / 60;
  const float walking = body.doing == Body::Doing::walking ? falls.per_minute_walking / 60 : 0;
  return body.touching > 0 ? walking + falls.per_second_touching : walking;
}

void fall(Tick now, Lying lying, Body& body) {
  body.doing = Body::Doing::fallen;
  body.kind = static_cast<std::uint8_t>(lying);
  body.since = now;
  body.velocity = {};
  body.turn_rate = 0;
}

/// A robot that falls at some rate.
struct Faller {
  const Falls* falls;
  const Mover* mover;
  float rate;  // [1/s] > 0

  std::array<std::uint32_t, 4> words() const {
    return draw(mover->world->key, static_cast<std::uint32_t>(mover->robot), Draw::fall, mover->world->tick);
  }
  void fall() const {
    const FallTable& table = falls->table;
    const Lying lying = table.given ? table.alone.lying(uniform(words()[1])) : Lying::on_back;
    motion::fall(mover->world->tick, lying, mover->world->bodies[mover->robot]);
  }
};

void perhaps_fall_alone(const Faller& faller) {
  if (falls_by(faller.words()[0], faller.rate, static_cast<float>(faller.mover->steps))) faller.fall();
}

/// Lets up to kLanes bodies fall, perhaps.
void perhaps_fall_together(std::span<const Faller> fallers) {
  FallLanes lanes;
  if (fallers.size() < kLanes) lanes = {};
  for (int i = 0; const auto& [falls, mover, rate] : fallers) {
    lanes.draws.set(i, mover->world->key, mover->robot, mover->world->tick);
    lanes.rate[i] = rate;
    lanes.ticks[i] = static_cast<float>(mover->steps);
    ++i;
  }
  in_lanes<draw_falls>(lanes);
  for (int i = 0; const Faller& faller : fallers)
    if (lanes.falls[i++] != 0) faller.fall();
}

}  // namespace

void perhaps_fall(const MotionParams& params, const Mover& mover) {
  const float rate = rate_of(params.model.falls, *mover.world, mover.robot);
  if (rate > 0) perhaps_fall_alone({&params.model.falls, &mover, rate});
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
    if (const float rate = rate_of(falls, *mover.world, mover.robot); rate > 0) batch.add({&falls, &mover, rate});
  batch.finish();
}

void topple(const MotionParams& params, Vec2 closing, int robot, World& world) {
  const FallTable& table = params.model.falls.table;
  Body& body = world.bodies[robot];
  if (!params.effects.falls || !table.given || closing == Vec2{} || body.doing >= Body::Doing::fallen) return;
  const ServoClass& own = class_of(table, world.key, robot);
  const Toppling& toppling = body.doing == Body::Doing::walking ? own.walking : own.standing;
  const auto words = draw(world.key, static_cast<std::uint32_t>(robot), Draw::collision, world.tick);
  if (uniform(words[0]) < toppling.probability(table.collisions.impulse(closing)))
    fall(world.tick, lying_after(closing), body);
}

Tick lie(const MotionParams& params, int robot, Tick now, Tick left, World& world) {
  Body& body = world.bodies[robot];
  const Attempt attempt = attempt_of(params.model.falls, world, robot);

  // nothing changes within these ticks
  const bool fallen = body.doing == Body::Doing::fallen;
  const Tick duration = std::max<Tick>(1, ticks(fallen ? attempt.lying : attempt.getting_up));
  const Tick elapsed = std::min(now - body.since, duration - 1);
  if (elapsed + left < duration) return left;

  const Tick used = duration - elapsed;
  body.since = now + used;
  if (fallen) {
    body.doing = Body::Doing::getting_up;
    return used;
  }
  const auto words = draw(world.key, static_cast<std::uint32_t>(robot), Draw::get_up, body.since);
  body.doing = uniform(words[0]) < attempt.failure ? Body::Doing::fallen : Body::Doing::standing;
  return used;
}

}  // namespace sim::motion
