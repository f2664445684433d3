#include "sim/perception/ball_filter.h"

#include <array>

#include "sim/math/lanes.h"
#include "sim/perception/estimate.h"
#include "sim/perception/image.h"

namespace sim::perception {
namespace {

constexpr float kLeastVariance = 1e-6f;  // [m²] of a percept: no camera is more accurate than 1 mm

/// Returns the estimate at a place with this variance. The velocity is unknown.
Estimate start(const BallFilter& filter, Vec2 position, float variance) {
  return {position, {}, variance, 0, squared(filter.first_velocity)};
}

/// A percept as the filter uses it.
struct Measured {
  Vec2 position, velocity;
  Images images;
};

/// Corrects the belief by two measurements with independent errors: the position at the mean time of the images, and
/// the velocity, if several images show it.
Estimate corrected(const Measured& percept, float variance, Estimate ball) {
  const Images& images = percept.images;
  {
    const float ago = images.middle;
    const float with_position = ball.variance - ago * ball.covariance;
    const float with_velocity = ball.covariance - ago * ball.velocity_variance;
    const float whole = 1 / (with_position - ago * with_velocity + variance / images.count);
    const Vec2 innovation = (percept.position - ball.position) - ago * (percept.velocity - ball.velocity);
    const float gain = with_position * whole, velocity_gain = with_velocity * whole;
    ball.position += gain * innovation;
    ball.velocity += velocity_gain * innovation;
    ball.variance -= gain * with_position;
    ball.covariance -= gain * with_velocity;
    ball.velocity_variance -= velocity_gain * with_velocity;
  }
  const float of_velocity = variance / images.spread;
  const float whole = 1 / (ball.velocity_variance + of_velocity);
  const Vec2 innovation = percept.velocity - ball.velocity;
  const float gain = ball.covariance * whole, rest = of_velocity * whole;
  const Estimate by_velocity{ball.position + gain * innovation, ball.velocity + (1 - rest) * innovation,
                             ball.variance - gain * ball.covariance, ball.covariance * rest,
                             ball.velocity_variance * rest};
  return select(images.spread != 0, by_velocity, ball);
}

/// The robots of one block that have a percept.
struct FilterBlock {
  BallLanes ball;
  Lane<Vec2> position, velocity;  // of the percept
  Lane<float> count, middle, spread;
  Lane<std::int32_t> stands, forgotten;
  Lane<std::int32_t> believed;
};

/// The constants of the filter.
struct FilterConstants {
  const Model& model;
  float height;  // [m] of the camera above the ball
};

void believe_percepts(FilterBlock& block, const FilterConstants& constants) {
  const BallFilter& filter = constants.model.filter;
  const ImageNoise standing = image_noise(constants.model, true), walking = image_noise(constants.model, false);
  const float most = squared(filter.lost_deviation), gate = squared(filter.reacquire);
  SIM_FOR_LANES(i) {
    const ImageNoise noise = select(block.stands[i] != 0, standing, walking);
    const Measured percept{block.position[i], block.velocity[i], {block.count[i], block.middle[i], block.spread[i]}};
    const Estimate ball = block.ball.get(i);

    // The expected place gives the variance of the percept. The percept's own place would give more weight to percepts
    // that seem near, and the ball would seem nearer than it is.
    const bool lost = ball.variance >= most;
    const float anew = percept_variance(noise, squared_length(percept.position), constants.height) + kLeastVariance;
    const float expected = percept_variance(noise, squared_length(ball.position), constants.height) + kLeastVariance;
    const float variance = lost ? anew : expected;
    const float square = squared_length(percept.position - ball.position);
    const bool elsewhere = square > gate * (ball.variance + variance);
    const bool several = percept.images.count >= 2;

    // restart there, doubt the percept, or follow it
    const bool restarts = lost | (elsewhere & ((block.forgotten[i] != 0) | several));
    const bool doubts = elsewhere & !restarts;
    const Estimate there = start(filter, percept.position, several ? most : anew);
    const Estimate uncertain = start(filter, ball.position, square / gate);
    const Estimate before = select(restarts, there, select(doubts, uncertain, ball));
    const Estimate after = corrected(percept, restarts ? anew : variance, before);
    block.ball.set(i, select((restarts & !several) | doubts, before, after));
    block.believed[i] = doubts ? 0 : 1;
  }
}

/// A robot with a percept of the ball.
struct Percipient {
  const Look* look;
  const BallPercept* percept;
  bool believed;
};

void gather_percept(const Percipient& one, int i, FilterBlock& block) {
  const agent::Ball& ball = one.look->beliefs->ball;
  block.ball.gather(i, ball);
  block.position.set(i, one.percept->position);
  block.velocity.set(i, one.percept->velocity);
  block.count[i] = one.percept->images.count;
  block.middle[i] = one.percept->images.middle;
  block.spread[i] = one.percept->images.spread;
  block.stands[i] = one.look->body().doing == Body::Doing::standing ? 1 : 0;
  block.forgotten[i] = !ball.visible && age(one.look->world->tick, ball.seen) >= kForgotten ? 1 : 0;
}

/// Updates the places of the believed balls. Sets `believed`.
void believe(const PerceptionParams& params, std::span<Percipient> all) {
  if (!params.effects.ball_noise) {
    for (const Percipient& one : all) {
      agent::Ball& ball = one.look->beliefs->ball;
      ball.position = one.percept->position;
      ball.velocity = one.percept->velocity;
      ball.variance = ball.covariance = ball.velocity_variance = 0;
    }
    return;
  }
  const FilterConstants constants{params.model, params.model.camera.height - params.ball.radius};
  FilterBlock block{};
  in_blocks(
      all, [&](const Percipient& one, int i) { gather_percept(one, i, block); },
      [&] { in_lanes<believe_percepts>(block, constants); },
      [&](Percipient& one, int i) {
        block.ball.scatter(i, one.look->beliefs->ball);
        one.believed = block.believed[i] != 0;
      });
}

/// Notes what the images showed besides the ball's place.
void note(const Look& look, const BallPercept& percept, bool believed) {
  agent::Ball& ball = look.beliefs->ball;
  // number of images in a row with, or without, the ball
  const bool visible = believed && percept.ago == 0;
  const std::uint32_t frames = visible == ball.visible ? ball.frames + look.steps : look.steps;
  ball.frames = static_cast<std::uint8_t>(frames < 255 ? frames : 255);
  ball.visible = visible;
  if (believed) {
    ball.seen = look.world->tick - percept.ago;
    ball.heat = percept.heat;
  } else if (ball.heat > 0) {
    const float rest = 1 - 0.1f * static_cast<float>(look.steps);
    ball.heat = rest > 0 ? rest * ball.heat : 0;
  }
}

}  // namespace

agent::Ball unknown_ball(const BallFilter& filter) {
  agent::Ball ball;
  ball.variance = squared(filter.lost_deviation);
  ball.velocity_variance = squared(filter.first_velocity);
  return ball;
}

void update(const PerceptionParams& params, std::span<const Look> looks, std::span<const BallPercept> percepts) {
  std::array<Percipient, kMostLooks> seeing;
  std::size_t count = 0;
  for (std::size_t i = 0; i < looks.size(); ++i) {
    if (percepts[i].seen)
      seeing[count++] = {&looks[i], &percepts[i], true};
    else
      note(looks[i], percepts[i], false);
  }
  believe(params, {seeing.data(), count});
  for (std::size_t i = 0; i < count; ++i) note(*seeing[i].look, *seeing[i].percept, seeing[i].believed);
}

}  // namespace sim::perception
