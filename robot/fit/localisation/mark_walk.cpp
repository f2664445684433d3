#include "robot/fit/localisation/mark_walk.h"

#include <algorithm>
#include <cmath>
#include <optional>

#include "robot/fit/math/angles.h"
#include "sim/perception/localisation.h"

namespace robot::fit {
namespace {

constexpr double kSmoothing = 0.2;  // [s] to either side
constexpr double kMarkGap = 1;      // [s] between two poses

/// Smooth true poses at moments in the order of their times.
class SmoothPoses {
 public:
  explicit SmoothPoses(const std::vector<TrueMoment>& truth) : truth_(truth) {}

  /// Returns the mean of the moments around one [s], or nothing without any.
  std::optional<TrueMoment> at(double seconds) {
    while (first_ < truth_.size() && truth_[first_].at < seconds - kSmoothing) ++first_;
    if (first_ == truth_.size() || truth_[first_].at > seconds + kSmoothing) return std::nullopt;
    const TrueMoment& reference = truth_[first_];
    double x = 0, y = 0, turn = 0, at = 0, count = 0;
    for (std::size_t i = first_; i < truth_.size() && truth_[i].at <= seconds + kSmoothing; ++i, ++count) {
      x += truth_[i].x, y += truth_[i].y, at += truth_[i].at;
      turn += wrapped(truth_[i].heading - reference.heading);
    }
    return TrueMoment{
        .at = at / count, .x = x / count, .y = y / count, .heading = wrapped(reference.heading + turn / count)};
  }

 private:
  const std::vector<TrueMoment>& truth_;
  std::size_t first_ = 0;
};

/// A robot of the simulator that follows a recorded walk.
class Follower {
 public:
  Follower(const MarkWalk& walk, const sim::Models& models, const sim::Effects& effects, const sim::field::Field& field,
           const sim::field::Marks& marks, std::uint64_t seed)
      : walk_(walk),
        model_(models.perception),
        perception_{.model = models.perception,
                    .effects = effects,
                    .field = field,
                    .marks = marks,
                    .contact = models.contact,
                    .ball = models.ball} {
    world_.key = {seed};
    world_.players = 1;
    world_.home_attacks = 1;
  }

  template <class See>
  void follow(See&& see) {
    double look_at = 0;
    for (const MarkMoment& moment : walk_.moments) {
      ++world_.tick;
      place(moment);
      if (moment.enters)
        enter();
      else
        step(moment);
      if (moment.falls) sim::perception::lose_pose(model_.localisation, world_, 0, beliefs_.pose);
      if (moment.at >= look_at) {
        look_at = moment.at + static_cast<double>(model_.localisation.mark_interval) - 1e-3;
        const sim::perception::Look look{&world_, &beliefs_, &cognition_, 0, 1};
        sim::perception::look_round(perception_, {&look, 1});
      }
      if (moment.counts) see(error_of(moment));
      last_ = moment.pose;
    }
  }

  struct Error {
    double place, heading;
  };

 private:
  void place(const MarkMoment& moment) {
    sim::Body& body = world_.bodies[0];
    body.position = moment.pose.position;
    body.heading = moment.pose.heading;
    body.facing = sim::direction(body.heading);
    body.head_yaw = moment.yaw;
    body.head_pitch = walk_.knows_head ? moment.upper_edge - model_.camera.upper_edge : 0;
    body.look = sim::direction(body.head_yaw);
    body.doing = moment.upright ? sim::Body::Doing::walking : sim::Body::Doing::getting_up;
  }

  void enter() {
    sim::perception::enter(perception_, world_, 0, beliefs_, cognition_);
    cognition_.odometry_scale = walk_.scale;
    cognition_.turn_scale = walk_.turn_scale;
  }

  /// Moves the belief by the odometry. Way and turn are those of the speeds, because true places scatter.
  void step(const MarkMoment& moment) {
    const sim::Body& body = world_.bodies[0];
    sim::Pose2& pose = beliefs_.pose.pose;
    const float turn = sim::normalized(body.heading - last_.heading);
    pose.heading = sim::normalized(pose.heading + walk_.turn_scale * turn);
    const sim::Vec2 moved = walk_.scale * sim::turned_back(body.position - last_.position, body.facing);
    pose.position += sim::turned(moved, sim::direction(pose.heading));
    cognition_.walked += walk_.scale * moment.way;
    const float turned = cognition_.turned + moment.turned / sim::perception::kTurnUnit + 0.5f;
    cognition_.turned = static_cast<std::uint16_t>(std::min(turned, 65535.f));
  }

  Error error_of(const MarkMoment& moment) const {
    const sim::Pose2& pose = beliefs_.pose.pose;
    return {.place = sim::distance(pose.position, moment.pose.position),
            .heading = std::abs(sim::normalized(pose.heading - moment.pose.heading))};
  }

  const MarkWalk& walk_;
  const sim::perception::Model& model_;
  sim::perception::PerceptionParams perception_;
  sim::World world_;
  sim::agent::Beliefs beliefs_;
  sim::perception::Cognition cognition_;
  sim::Pose2 last_;
};

/// Sums up the errors of moments.
class ErrorSum {
 public:
  void add(double place, double square, double square_turn) {
    const auto bin = static_cast<std::size_t>(std::max(0., place) / kMarkBin);
    if (bin < sum_.histogram.size()) sum_.histogram[bin] += 1;
    sum_.place += square, sum_.heading += square_turn;
    ++sum_.moments;
  }

  MarkErrors mean() const {
    MarkErrors mean = sum_;
    const double count = std::max(1., static_cast<double>(sum_.moments));
    mean.place /= count, mean.heading /= count;
    for (double& share : mean.histogram) share /= count;
    return mean;
  }

 private:
  MarkErrors sum_;
};

}  // namespace

MarkWalk mark_walk(const WatchedMotion& motion, const std::vector<PoseError>& errors, const TruthNoise& noise) {
  MarkWalk walk;
  if (motion.status.empty()) return walk;
  walk.knows_head = !motion.heads.empty();
  SmoothPoses truth(motion.truth);
  std::size_t status_index = 0, head_index = 0;
  double last = -INFINITY;
  for (const PoseError& error : errors) {
    const auto there = truth.at(error.at);
    const StatusAt* status = latest(motion.status, error.at, status_index);
    if (!there || !status) continue;
    const double sign = error.sign;
    const double turn = sign > 0 ? 0 : M_PI;
    const double dt = error.at - last;
    const HeadAt* head = latest(motion.heads, error.at, head_index);
    MarkMoment moment{.at = error.at,
                      .pose = {.position = {static_cast<float>(sign * there->x), static_cast<float>(sign * there->y)},
                               .heading = static_cast<float>(wrapped(there->heading + turn))},
                      .upright = error.upright};
    moment.enters = dt > kMarkGap || error.entered;
    moment.falls = error.fell;
    if (dt <= kMarkGap) {
      moment.way = static_cast<float>(status->speed * dt);
      moment.turned = static_cast<float>(status->turn_rate * dt);
    }
    if (head) moment.yaw = static_cast<float>(head->yaw), moment.upper_edge = static_cast<float>(head->upper_edge);
    moment.counts = error.upright && !error.flipped && error.since > kSettled;
    moment.square =
        std::min(error.far() * error.far(), kMostPlace * kMostPlace) - 2 * error.noise * noise.place * noise.place;
    moment.square_turn =
        std::min(error.heading * error.heading, kMostTurn * kMostTurn) - error.noise * noise.heading * noise.heading;
    walk.moments.push_back(moment);
    last = error.at;
  }
  return walk;
}

MarkErrors recorded_errors(const std::vector<MarkWalk>& walks) {
  ErrorSum sum;
  for (const MarkWalk& walk : walks)
    for (const MarkMoment& moment : walk.moments)
      if (moment.counts) sum.add(std::sqrt(std::max(0., moment.square)), moment.square, moment.square_turn);
  return sum.mean();
}

MarkErrors simulated_errors(const std::vector<MarkWalk>& walks, const sim::Models& models,
                            const sim::field::Field& field, std::uint64_t seed, std::vector<MarkSquares>* seen) {
  const sim::field::Marks marks = sim::field::marks_of(field);
  sim::Effects effects = models.effects;
  effects.odometry_drift = true, effects.pose_flips = false;
  ErrorSum sum;
  for (std::size_t i = 0; i < walks.size(); ++i)
    Follower(walks[i], models, effects, field, marks, 1000 * seed + i).follow([&](const auto& error) {
      const MarkSquares squares{.place = std::min(error.place * error.place, kMostPlace * kMostPlace),
                                .heading = std::min(error.heading * error.heading, kMostTurn * kMostTurn)};
      sum.add(error.place, squares.place, squares.heading);
      if (seen) seen->push_back(squares);
    });
  return sum.mean();
}

}  // namespace robot::fit
