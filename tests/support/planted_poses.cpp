#include "tests/support/planted_poses.h"

#include <algorithm>
#include <cmath>
#include <random>

#include "robot/fit/math/angles.h"
#include "sim/io/matchup.h"
#include "sim/perception/localisation.h"
#include "sim/perception/odometry.h"

namespace robot::tests {
namespace {

using sim::Body;

/// The parameters of a match, which are read once.
const sim::Params& planted_match() {
  static const auto game = sim::io::prepare({.rules = "spl2025"});
  return game->params;
}

/// The walk, tick by tick.
class PoseWalker {
 public:
  PoseWalker(const PlantedPoses& planted, std::uint64_t seed)
      : planted_(planted),
        params_(planted_match()),
        random_(seed),
        perception_{.model = planted.models.perception,
                    .effects = planted.models.effects,
                    .field = params_.rules.field,
                    .marks = params_.marks,
                    .contact = planted.models.contact,
                    .ball = planted.models.ball} {
    world_.key = {seed};
    world_.players = 1;
    world_.home_attacks = planted.attacks_plus ? 1.f : -1.f;
    motion_.name = "robot " + std::to_string(seed);
    motion_.place_deviation = std::max(planted.truth_error, 0.001);
    motion_.is_simulated = true;
  }

  fit::WatchedMotion walk() && {
    place();
    const auto ticks = static_cast<sim::Tick>(std::lround(planted_.minutes * 60 * 30));
    write_game();
    write_truth();
    while (world_.tick < ticks) {
      if (planted_.changes_sides && world_.tick == ticks / 2) change_sides();
      if (body().doing != Body::Doing::removed) perceive();
      move();
      ++world_.tick;
      write_truth();
      write_body();
      if (world_.tick % 15 == 0) write_game();
    }
    return std::move(motion_);
  }

 private:
  Body& body() { return world_.bodies[0]; }
  double now() const { return world_.tick / 30.; }
  double uniform(double from, double to) { return std::uniform_real_distribution<double>(from, to)(random_); }
  double normal() { return normal_(random_); }
  bool happens(double per_minute) { return uniform(0, 1) < per_minute / 60 / 30; }

  void place() {
    body().position = {static_cast<float>(uniform(-3.5, 3.5)), static_cast<float>(uniform(-2.5, 2.5))};
    body().heading = static_cast<float>(uniform(-3, 3));
    body().facing = sim::direction(body().heading);
    body().doing = Body::Doing::standing;
    body().velocity = {};
    body().turn_rate = 0;
    sim::perception::enter(perception_, world_, 0, beliefs_, cognition_);
    write_pose();
  }

  void change_sides() {
    world_.home_attacks = -world_.home_attacks;
    half_ = 2;
    write_game();
    place();
    motion_.truth.pop_back();  // of the old place at this moment
    write_truth();
  }

  void perceive() {
    const sim::perception::Look look{&world_, &beliefs_, &cognition_, 0, 1};
    sim::perception::predict(perception_, {&look, 1});
    sim::perception::localise(perception_, {&look, 1});
    write_pose();
  }

  void move() {
    const sim::Tick since = world_.tick - body().since;
    switch (body().doing) {
      case Body::Doing::removed:
        if (since > 300) place(), write_game(), body().since = world_.tick;
        return;
      case Body::Doing::fallen:
        if (since >= 30) body().doing = Body::Doing::getting_up, body().since = world_.tick;
        return;
      case Body::Doing::getting_up:
        if (since < 66) return;
        body().since = world_.tick;
        body().doing = uniform(0, 1) < 0.1 ? Body::Doing::fallen : Body::Doing::standing;
        return;
      default: break;
    }
    if (happens(planted_.penalties_per_minute)) return leave();
    if (world_.tick >= next_) choose();
    if (body().doing == Body::Doing::walking && happens(planted_.falls_per_minute)) return fall();
    step();
  }

  void leave() {
    body().doing = Body::Doing::removed;
    body().since = world_.tick;
    body().velocity = {};
    body().turn_rate = 0;
    write_game();
  }

  void fall() {
    body().doing = Body::Doing::fallen;
    body().since = world_.tick;
    body().velocity = {};
    body().turn_rate = 0;
  }

  void choose() {
    next_ = world_.tick + static_cast<sim::Tick>(uniform(30, 120));
    const double kind = uniform(0, 1);
    const bool stands = kind < 0.2, turns = kind < 0.35;
    body().doing = stands ? Body::Doing::standing : Body::Doing::walking;
    body().velocity = {stands || turns ? 0 : static_cast<float>(uniform(0.1, 0.25)), 0};
    body().turn_rate = stands ? 0 : static_cast<float>(uniform(-1, 1) * (turns ? 1 : 0.5));
    // back to the middle from the edge
    const sim::Vec2 home = -body().position;
    if (std::abs(home.x) > 3.8f || std::abs(home.y) > 2.6f) {
      const float turn = sim::normalized(sim::angle_of(home) - body().heading);
      body().doing = Body::Doing::walking;
      body().velocity = {std::abs(turn) > 0.5f ? 0.f : 0.2f, 0};
      body().turn_rate = turn / 2;
      next_ = world_.tick + 60;
    }
  }

  void step() {
    const auto& model = planted_.models.perception.localisation;
    const float dt = sim::kTickDuration;
    body().position += sim::turned(dt * body().velocity, body().facing);
    const float turn = dt * body().turn_rate;
    body().heading = sim::normalized(body().heading + turn);
    body().facing = sim::direction(body().heading);
    body().head_yaw = static_cast<float>(0.9 * std::sin(now()));
    body().head_pitch = 0.1f;
    body().look = sim::direction(body().head_yaw);
    const double way = dt * sim::length(body().velocity), turned = std::abs(turn);
    const double noise = model.translation_noise * std::sqrt(way);
    const double x = way * cognition_.odometry_scale + noise * normal(), y = noise * normal();
    odometry_.x += std::cos(odometry_.heading) * x - std::sin(odometry_.heading) * y;
    odometry_.y += std::sin(odometry_.heading) * x + std::cos(odometry_.heading) * y;
    odometry_.heading = fit::wrapped(
        odometry_.heading + turn * cognition_.turn_scale +
        normal() * std::sqrt(std::pow(model.rotation_noise, 2) * turned + std::pow(model.rotation_per_metre, 2) * way));
  }

  void write_pose() {
    const sim::agent::Pose& pose = beliefs_.pose;
    motion_.poses.push_back({.at = now() + planted_.late,
                             .x = pose.pose.position.x,
                             .y = pose.pose.position.y,
                             .heading = pose.pose.heading,
                             .deviation = pose.deviation,
                             .deviation_heading = pose.deviation_heading});
  }

  void write_truth() {
    if (body().doing == Body::Doing::removed) return;
    motion_.truth.push_back({.at = now(),
                             .x = body().position.x + planted_.truth_error * normal(),
                             .y = body().position.y + planted_.truth_error * normal(),
                             .heading = fit::wrapped(body().heading + planted_.heading_error * normal()),
                             .fallen = sim::lies(body())});
  }

  void write_body() {
    odometry_.at = now() + planted_.late;
    motion_.odometry.push_back(odometry_);
    using Status = fit::StatusAt::Body;
    const Body::Doing doing = body().doing;
    motion_.status.push_back({.at = now() + planted_.late,
                              .body = doing == Body::Doing::fallen       ? Status::fallen
                                      : doing == Body::Doing::getting_up ? Status::getting_up
                                                                         : Status::upright,
                              .speed = sim::length(body().velocity),
                              .turn_rate = std::abs(body().turn_rate)});
    motion_.heads.push_back({.at = now() + planted_.late,
                             .yaw = body().head_yaw,
                             .upper_edge = planted_.models.perception.camera.upper_edge + body().head_pitch});
  }

  void write_game() {
    motion_.games.push_back({.at = now() + planted_.late,
                             .penalised = body().doing == Body::Doing::removed,
                             .moves = true,
                             .half = half_,
                             .attacks_plus = world_.home_attacks > 0});
  }

  const PlantedPoses& planted_;
  const sim::Params& params_;
  std::mt19937_64 random_;
  std::normal_distribution<double> normal_;
  sim::perception::PerceptionParams perception_;
  sim::World world_;
  sim::agent::Beliefs beliefs_;
  sim::perception::Cognition cognition_;
  fit::OdometryAt odometry_;
  fit::WatchedMotion motion_;
  sim::Tick next_ = 0;
  int half_ = 1;
};

}  // namespace

sim::Models match_models() { return planted_match().teams[0].models; }

fit::WatchedMotion planted_pose_walk(const PlantedPoses& planted, std::uint64_t seed) {
  return PoseWalker(planted, seed).walk();
}

std::vector<fit::WatchedMotion> planted_poses(const PlantedPoses& planted, std::size_t robots, std::uint64_t seed) {
  std::vector<fit::WatchedMotion> walks;
  for (std::size_t i = 0; i < robots; ++i) walks.push_back(planted_pose_walk(planted, 1000 * seed + i));
  return walks;
}

}  // namespace robot::tests
