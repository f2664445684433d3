#include "robot/fit/walking/mean_walk.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>

#include "sim/math/tick.h"
#include "sim/motion/gait.h"
#include "sim/motion/glide.h"
#include "sim/motion/walk.h"

namespace robot::fit {
namespace {

using sim::motion::Command, sim::motion::Gait, sim::motion::Luck, sim::motion::Walk;

constexpr std::size_t kLucks = 16;  // equally likely
constexpr float kWalkTick = sim::kTickDuration;

/// Returns the means of the sixteenths of the triangular distribution with standard deviation 1 (sim/motion/luck.h), scaled to
/// that deviation.
std::array<float, kLucks> luck_deviates() {
  std::array<double, kLucks> means{};
  double squares = 0;
  for (std::size_t i = 0; i < kLucks / 2; ++i) {
    // the lower half of the distribution: its quantile at p is √6 (√(2p) - 1)
    const double from = static_cast<double>(i) / kLucks, to = static_cast<double>(i + 1) / kLucks;
    const double root = std::sqrt(8.) / 3 * (std::pow(to, 1.5) - std::pow(from, 1.5)) * kLucks;
    means[i] = std::sqrt(6.) * (root - 1);
    means[kLucks - 1 - i] = -means[i];
    squares += 2 * means[i] * means[i] / kLucks;
  }
  std::array<float, kLucks> scaled{};
  for (std::size_t i = 0; i < kLucks; ++i) scaled[i] = static_cast<float>(means[i] / std::sqrt(squares));
  return scaled;
}

/// Returns lucks of which each part alone has the distribution of the simulator. The parts hardly depend on each other.
std::array<Luck, kLucks> lucks_of(const Walk& walk) {
  static const std::array<float, kLucks> kLuckDeviates = luck_deviates();
  std::array<Luck, kLucks> lucks;
  for (std::size_t i = 0; i < kLucks; ++i) {
    const float x = kLuckDeviates[i], y = kLuckDeviates[(7 * i + 3) % kLucks],
                turn = kLuckDeviates[(5 * i + 9) % kLucks];
    lucks[i] = {{std::max(0.f, 1 + walk.speed_noise * x), std::max(0.f, 1 + walk.speed_noise * y)},
                walk.turn_noise * turn};
  }
  return lucks;
}

/// Returns the gait for the next `dt` seconds.
Gait gait_with(const Walk& walk, const Command& command, float dt, const Luck& luck) {
  const sim::motion::Errand errand = sim::motion::errand_of(command);
  return sim::motion::gait_of(walk, true, std::clamp(command.gain, 0.f, 1.f), errand, dt, luck);
}

WalkRates gait_rates_of(const Gait& gait) { return {gait.velocity.x, gait.velocity.y, gait.turn_rate}; }

/// A body without a place, as in sim/motion/walk.cpp.
class Legs {
 public:
  Legs(const Walk& walk, bool walks) : walk_(walk), doing_(walks ? Doing::walking : Doing::standing) {}

  /// Moves for one tick, at whose beginning a step with that luck may begin. The next one begins in `until_next` seconds.
  /// Returns the mean rates.
  WalkRates move(const Command& command, const Luck& luck, bool begins, float until_next) {
    const bool moves = velocity_ != sim::Vec2{} || turn_rate_ != 0;
    const bool in_step = doing_ == Doing::walking || (doing_ == Doing::stopping && moves);
    float moving = kWalkTick;  // [s] of the tick
    if (!in_step || begins) {
      moving = asks_to_walk(command) ? go() : halt(moves);
      if (moving <= 0) return {};
      wanted_ = doing_ == Doing::walking ? gait_with(walk_, command, until_next, luck) : Gait{};
    }
    if (doing_ == Doing::stopping) since_ += kWalkTick;
    const auto velocity = sim::motion::approach(velocity_, wanted_.velocity, walk_.acceleration * moving);
    const auto rate = sim::motion::approach(turn_rate_, wanted_.turn_rate, walk_.turn_acceleration * moving);
    velocity_ = velocity.end, turn_rate_ = rate.end;
    const float share = moving / kWalkTick;
    return {share * velocity.mean.x, share * velocity.mean.y, share * rate.mean};
  }

 private:
  enum class Doing : unsigned char { standing, starting, walking, stopping };

  /// Returns the time [s] of this tick in which the body walks.
  float go() {
    float moving = kWalkTick;
    if (doing_ == Doing::standing) doing_ = Doing::starting, since_ = 0;
    if (doing_ == Doing::starting) {
      since_ += kWalkTick;
      moving = std::min(kWalkTick, since_ - walk_.start_delay);
    }
    if (moving > 0) doing_ = Doing::walking;
    return moving;
  }

  /// Returns the time [s] of this tick in which the body brakes.
  float halt(bool moves) {
    if (doing_ == Doing::starting) doing_ = Doing::standing;
    if (doing_ == Doing::walking) doing_ = Doing::stopping, since_ = 0;
    if (doing_ == Doing::stopping && !moves && since_ >= walk_.stop_delay) doing_ = Doing::standing;
    return doing_ == Doing::stopping ? kWalkTick : 0;
  }

  const Walk& walk_;
  Doing doing_;
  float since_ = 0;  // [s] in `doing_`
  sim::Vec2 velocity_;
  float turn_rate_ = 0;
  Gait wanted_;  // of the present step
};

/// Returns which luck a body has in a step. In each step all bodies have different ones, and from step to step they are as
/// if drawn.
std::size_t luck_of(std::size_t body, std::uint32_t step) {
  // a finalizer of murmur3: its bits are as if drawn
  std::uint32_t drawn = (step + 1) * 0x9e3779b9U;
  drawn = (drawn ^ (drawn >> 16)) * 0x85ebca6bU;
  drawn ^= drawn >> 13;
  return (body * (2 * (drawn & 7U) + 1) + (drawn >> 3)) % kLucks;
}

}  // namespace

bool asks_to_walk(const Command& command) {
  switch (command.body) {
    case Command::Body::walk_speed: return command.walk != sim::Vec2{} || command.turn != 0;
    case Command::Body::walk_to:
      return sim::squared_length(command.walk) > sim::motion::kArrived * sim::motion::kArrived ||
             std::abs(sim::motion::errand_of(command).turn) > sim::motion::kArrivedTurn;
    default: return false;
  }
}

MeanGait mean_gait(const Walk& walk, const Command& command) {
  MeanGait gait;
  WalkRates squares;
  for (const Luck& luck : lucks_of(walk)) {
    const WalkRates one = gait_rates_of(gait_with(walk, command, walk.step_duration, luck));
    gait.mean.x += one.x / kLucks, gait.mean.y += one.y / kLucks, gait.mean.turn += one.turn / kLucks;
    squares.x += one.x * one.x / kLucks, squares.y += one.y * one.y / kLucks;
    squares.turn += one.turn * one.turn / kLucks;
  }
  const auto variance = [](double square, double mean) { return std::max(0., square - mean * mean); };
  gait.variance = {variance(squares.x, gait.mean.x), variance(squares.y, gait.mean.y),
                   variance(squares.turn, gait.mean.turn)};
  return gait;
}

std::vector<WalkRates> mean_walk(const Walk& walk, const std::vector<Command>& commands) {
  std::vector<WalkRates> rates(commands.size());
  const std::array<Luck, kLucks> lucks = lucks_of(walk);
  const float a_tick = kWalkTick / walk.step_duration;
  for (std::size_t body = 0; body < kLucks; ++body) {
    Legs legs(walk, !commands.empty() && asks_to_walk(commands.front()));
    float begun = (static_cast<float>(body) + 0.5f) / kLucks;  // [steps]
    std::uint32_t step = 0;
    const Luck* luck = &lucks[luck_of(body, step)];
    for (std::size_t i = 0; i < commands.size(); ++i) {
      const bool begins = begun >= 1 || i == 0;
      if (begun >= 1) begun -= 1, luck = &lucks[luck_of(body, ++step)];
      // a body that begins to walk within a step takes what is left of it; steps begin with a tick, half a tick later on average
      const float until_next = (1 - begun) * walk.step_duration + kWalkTick / 2;
      const WalkRates moved = legs.move(commands[i], *luck, begins, until_next);
      begun += a_tick;
      rates[i].x += moved.x / kLucks, rates[i].y += moved.y / kLucks, rates[i].turn += moved.turn / kLucks;
    }
  }
  return rates;
}

}  // namespace robot::fit
