#include "tests/support/planted_sights.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <random>
#include <string>

namespace robot::tests {
namespace {

constexpr double kRollBegin = 2.5;   // [s] after the begin of an episode
constexpr double kFriction = 0.3;    // [m/s²]
constexpr double kWalk = 0.2;        // [m/s]
constexpr double kTurnRate = 0.3;    // [rad/s]
constexpr double kBeliefAge = 0.05;  // [s] more than that of percepts
constexpr double kSightsBeginNs = 1e12;

struct Spot {
  double x = 0, y = 0;
};

/// One recording while it is made.
class SightMaker {
 public:
  SightMaker(const PlantedSights& planted, std::uint64_t seed) : planted_(planted), random_(seed) {
    record_.epoch_ns = static_cast<std::uint64_t>(kSightsBeginNs);
    record_.ball_deviation = std::max(0.02, planted.truth_error);
    late_ = planted.late * normal_(random_);
  }

  void episode(std::size_t number) {
    const double begin = 7. * static_cast<double>(number);
    walks_ = number % 2 == 1;
    start_ = {uniform_(random_), uniform_(random_)};
    heading_ = 6 * uniform_(random_) - 3;
    const double distance = between(planted_.nearest, planted_.farthest), aside = uniform_(random_) - 0.5;
    rest_ = {start_.x + distance * std::cos(heading_ + aside), start_.y + distance * std::sin(heading_ + aside)};
    direction_ = 2 * std::numbers::pi * uniform_(random_);
    speed_ = between(0.6, 1.8);
    for (int i = 0; i < 180; ++i) image(begin, i / 30.);
  }

  void finish(const std::string& name, SightsOfGames& into) && {
    record_.robots.push_back({.name = "14/2", .path = path_});
    auto robot = std::make_unique<fit::WatchedRobot>();
    robot->name = name;
    robot->session.folder = "/" + name;
    robot->game = std::make_shared<const fit::TrueGame>(fit::TrueGame{.name = name, .record = std::move(record_)});
    robot->path = std::move(path_);
    robot->clock.deviation = planted_.late;
    seen_.robot = robot.get();
    into.robots.push_back(std::move(robot));
    into.seen.push_back(std::move(seen_));
  }

 private:
  double between(double least, double most) { return least + (most - least) * uniform_(random_); }

  Spot ball_at(double t) const {
    const double rolls = std::clamp(t - kRollBegin, 0., speed_ / kFriction);
    const double way = speed_ * rolls - kFriction * rolls * rolls / 2;
    return {rest_.x + way * std::cos(direction_), rest_.y + way * std::sin(direction_)};
  }

  void image(double begin, double t) {
    const double walked = walks_ ? kWalk * t : 0, turned = walks_ ? kTurnRate * std::sin(t) : 0;
    const Spot own{start_.x + walked * std::cos(heading_), start_.y + walked * std::sin(heading_)};
    const double heading = heading_ + turned, at = begin + t;
    const auto with_error = [&](double place) { return place + planted_.truth_error * normal_(random_); };
    const Spot ball = ball_at(t);
    record_.ball.push_back({.at = at, .x = with_error(ball.x), .y = with_error(ball.y)});
    record_.sightings.push_back({.at = at, .seen = true});
    path_.push_back({.at = at, .x = with_error(own.x), .y = with_error(own.y)});
    if (planted_.has_heading)
      path_.back().heading = std::remainder(heading + planted_.heading_error * normal_(random_), 2 * std::numbers::pi);
    // the robot's clock is ahead by `late_`, which nobody knows
    const auto capture_ns = static_cast<std::uint64_t>(std::llround(kSightsBeginNs + (at + late_) * 1e9));
    if (planted_.has_gait)
      seen_.gaits.push_back({.capture_ns = capture_ns, .gait = walks_ ? fit::Gait::moving : fit::Gait::standing});
    see(capture_ns, own, heading, ball_at(t - planted_.lag), seen_.percepts);
    see(capture_ns, own, heading, ball_at(t - planted_.lag - kBeliefAge), seen_.beliefs);
  }

  void see(std::uint64_t capture_ns, const Spot& own, double heading, const Spot& ball,
           std::vector<fit::SeenBall>& into) {
    const double distance = std::hypot(ball.x - own.x, ball.y - own.y);
    const double tilt = std::hypot(walks_ ? planted_.tilt_walking : planted_.tilt, planted_.pixels);
    const double roll = std::hypot(planted_.roll, planted_.pixels);
    double elevation = std::atan2(planted_.height, distance) + planted_.elevation_bias + tilt * normal_(random_);
    double bearing =
        std::atan2(ball.y - own.y, ball.x - own.x) - heading + planted_.bearing_bias + roll * normal_(random_);
    if (uniform_(random_) < planted_.false_balls) elevation = between(0.1, 0.8), bearing = between(-0.5, 0.5);
    const double seen = planted_.height / std::tan(elevation);
    if (elevation > 0 && seen < 12)
      into.push_back(
          {.capture_ns = capture_ns, .distance = seen, .bearing = std::remainder(bearing, 2 * std::numbers::pi)});
  }

  const PlantedSights& planted_;
  std::mt19937_64 random_;
  std::normal_distribution<double> normal_;
  std::uniform_real_distribution<double> uniform_;
  double late_ = 0;  // [s]
  bool walks_ = false;
  Spot start_, rest_;
  double heading_ = 0, direction_ = 0, speed_ = 0;
  lab::TruthRecord record_;
  lab::Path path_;
  fit::SeenBalls seen_;
};

}  // namespace

SightsOfGames planted_sights(const PlantedSights& planted, std::uint64_t seed) {
  SightsOfGames games;
  for (std::size_t i = 0; i < planted.recordings; ++i) {
    SightMaker maker(planted, 1000 * seed + i);
    for (std::size_t episode = 0; episode < planted.episodes; ++episode) maker.episode(episode);
    std::move(maker).finish("game " + std::to_string(i), games);
  }
  return games;
}

}  // namespace robot::tests
