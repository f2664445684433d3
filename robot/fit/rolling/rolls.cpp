#include "robot/fit/rolling/rolls.h"

#include <algorithm>
#include <cmath>
#include <optional>

#include "robot/fit/math/least_squares.h"

namespace robot::fit {
namespace {

constexpr double kReach = 0.35;       // [m] a robot's radius, a ball's, and the error of both
constexpr double kLeastSpeed = 0.25;  // [m/s] below, the ball may stop within the roll
constexpr double kTurn = 0.985;       // cosine of 10°
constexpr double kFaster = 0.15;      // [m/s] more than the least speed so far: it was pushed
constexpr double kShortest = 0.5;     // [s]
constexpr double kEnd = 0.1;          // [s] left out at both ends, where the smooth curve knows of the touch
constexpr double kBent = 0.2;         // [m/s²] across the way, beyond five deviations
constexpr std::size_t kFewestPlaces = 10;
constexpr double kLeastScatter = 0.0005;  // [m] of places: what a message's numbers are worth

/// The ball at one of the truth's moments.
struct Moment {
  double at, x, y;
  double speed_x, speed_y;

  double speed() const { return std::hypot(speed_x, speed_y); }
};

bool is_touched(const lab::TruthRecord& truth, const lab::PlaceAt& ball) {
  return std::ranges::any_of(truth.robots, [&](const lab::TrueRobotPath& robot) {
    const auto place = lab::place_at(robot.path, ball.at);
    return place && std::hypot(place->x - ball.x, place->y - ball.y) < kReach;
  });
}

/// The coefficients of c0 + c1 t + c2 t² through one coordinate, t from the middle of the roll.
struct Parabola {
  Vector c;
  double squares = 0;  // [m²] sum of the squared distances from it
};

/// The parts of the normal equations that depend on the times alone.
std::vector<Vector> powers_of(const std::vector<Moment>& moments, double middle) {
  std::vector<Vector> powers(3, Vector(3));
  for (const Moment& moment : moments) {
    const double t = moment.at - middle;
    const double terms[3] = {1, t, t * t};
    for (std::size_t i = 0; i < 3; ++i)
      for (std::size_t k = 0; k < 3; ++k) powers[i][k] += terms[i] * terms[k];
  }
  return powers;
}

std::optional<Parabola> parabola_through(const std::vector<Moment>& moments, double middle,
                                         double Moment::*coordinate) {
  Vector products(3);
  for (const Moment& moment : moments) {
    const double t = moment.at - middle, value = moment.*coordinate;
    products[0] += value, products[1] += value * t, products[2] += value * t * t;
  }
  auto c = solve(powers_of(moments, middle), products);
  if (!c) return std::nullopt;
  Parabola parabola{.c = std::move(*c)};
  for (const Moment& moment : moments) {
    const double t = moment.at - middle;
    parabola.squares += std::pow(moment.*coordinate - parabola.c[0] - parabola.c[1] * t - parabola.c[2] * t * t, 2);
  }
  return parabola;
}

/// Returns the roll through these moments, or nothing if they are too few or no roll.
std::optional<Roll> roll_of(std::vector<Moment> moments, double deviation, std::size_t recording) {
  if (moments.empty()) return std::nullopt;
  const double begin = moments.front().at + kEnd, end = moments.back().at - kEnd;
  std::erase_if(moments, [&](const Moment& moment) { return moment.at < begin || moment.at > end; });
  if (moments.size() < kFewestPlaces || end - begin < kShortest) return std::nullopt;
  const double middle = (begin + end) / 2;
  const auto x = parabola_through(moments, middle, &Moment::x), y = parabola_through(moments, middle, &Moment::y);
  const auto curvature = solve(powers_of(moments, middle), {0, 0, 1});
  if (!x || !y || !curvature) return std::nullopt;
  const double speed = std::hypot(x->c[1], y->c[1]);
  if (speed < kLeastSpeed) return std::nullopt;
  const double freedom = 2 * static_cast<double>(moments.size()) - 6;
  const double scatter = std::max(kLeastScatter, std::sqrt((x->squares + y->squares) / freedom));
  const double of_acceleration = 2 * scatter * std::sqrt((*curvature)[2]);
  const double ux = x->c[1] / speed, uy = y->c[1] / speed;
  const double along = 2 * (x->c[2] * ux + y->c[2] * uy), across = 2 * (y->c[2] * ux - x->c[2] * uy);
  if (scatter > 3 * deviation || std::abs(across) > kBent + 5 * of_acceleration) return std::nullopt;
  const double half = (end - begin) / 2;
  return Roll{.recording = recording,
              .at = begin,
              .duration = end - begin,
              .speed = speed - along * half,
              .end_speed = speed + along * half,
              .deceleration = -along,
              .deviation = of_acceleration};
}

/// Collects moments to rolls.
class RollFinder {
 public:
  RollFinder(const lab::TruthRecord& truth, std::size_t recording) : truth_(truth), recording_(recording) {}

  void add(const Moment& moment) {
    if (!moments_.empty() && !continues(moment)) end();
    least_ = moments_.empty() ? moment.speed() : std::min(least_, moment.speed());
    moments_.push_back(moment);
  }

  void end() {
    if (auto roll = roll_of(std::move(moments_), truth_.ball_deviation, recording_)) rolls_.push_back(*roll);
    moments_.clear();
  }

  std::vector<Roll> rolls() && { return std::move(rolls_); }

 private:
  bool continues(const Moment& moment) const {
    const Moment& first = moments_.front();
    const double cosine = (first.speed_x * moment.speed_x + first.speed_y * moment.speed_y) /
                          std::max(1e-9, first.speed() * moment.speed());
    return cosine > kTurn && moment.speed() < least_ + kFaster &&
           moment.at - moments_.back().at <= lab::SmoothCurve::kLongestGap;
  }

  const lab::TruthRecord& truth_;
  const std::size_t recording_;
  std::vector<Moment> moments_;
  double least_ = 0;  // [m/s] least speed so far
  std::vector<Roll> rolls_;
};

}  // namespace

std::vector<Roll> rolls_in(const lab::TruthRecord& truth, std::size_t recording) {
  const lab::SmoothCurve x = lab::curve_of(truth.ball, &lab::PlaceAt::x),
                         y = lab::curve_of(truth.ball, &lab::PlaceAt::y);
  RollFinder finder(truth, recording);
  for (const lab::PlaceAt& ball : truth.ball) {
    const auto speed_x = x.rate_at(ball.at), speed_y = y.rate_at(ball.at);
    const bool rolls = speed_x && speed_y && std::hypot(*speed_x, *speed_y) >= kLeastSpeed && !is_touched(truth, ball);
    if (rolls)
      finder.add({.at = ball.at, .x = ball.x, .y = ball.y, .speed_x = *speed_x, .speed_y = *speed_y});
    else
      finder.end();
  }
  finder.end();
  return std::move(finder).rolls();
}

}  // namespace robot::fit
