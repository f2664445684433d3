#include "robot/fit/rolling/rolls.h"

#include <algorithm>
#include <cmath>
#include <optional>

#include "robot/fit/math/least_squares.h"

namespace robot::fit {
namespace {

constexpr double kReach = 0.35;       // [m] a robot's radius, a ball's, and the error of both
constexpr double kLeastSpeed = 0.25;  // [m/s] below, the ball may stop within the roll
constexpr double kTurn = 0.175;       // [rad] 10°: it met something
constexpr double kFaster = 0.15;      // [m/s] more than the least speed so far: it was pushed
constexpr double kDoubt = 3;          // standard deviations of a velocity that are added to both
constexpr double kShortest = 0.5;     // [s]
constexpr double kWindow = 0.2;       // [s] to either side, over which a velocity is measured
constexpr double kBent = 0.2;         // [m/s²] across the way, beyond five deviations
constexpr std::size_t kFewestInWindow = 4, kFewestPlaces = 10;
constexpr double kLeastScatter = 0.0005;  // [m] of places: what a message's numbers are worth

/// The ball at one of the truth's moments.
struct Moment {
  double at, x, y;
  double speed_x, speed_y;
  double deviation;  // [m/s] of either speed

  double speed() const { return std::hypot(speed_x, speed_y); }
};

/// Returns the moment of a place: the velocity is the slope of straight lines through the places around it. Nothing if they are
/// too few, or on one side only.
std::optional<Moment> moment_at(const lab::Path& path, std::size_t index, double deviation) {
  const double at = path[index].at;
  std::size_t first = index, last = index;
  while (first > 0 && path[first - 1].at >= at - kWindow) --first;
  while (last + 1 < path.size() && path[last + 1].at <= at + kWindow) ++last;
  const auto count = static_cast<double>(last - first + 1);
  if (last - first + 1 < kFewestInWindow || first == index || last == index) return std::nullopt;
  double t = 0, x = 0, y = 0;
  for (std::size_t i = first; i <= last; ++i) t += path[i].at - at, x += path[i].x, y += path[i].y;
  double tt = 0, tx = 0, ty = 0;
  for (std::size_t i = first; i <= last; ++i) {
    const double from = path[i].at - at - t / count;
    tt += from * from, tx += from * (path[i].x - x / count), ty += from * (path[i].y - y / count);
  }
  return Moment{.at = at,
                .x = path[index].x,
                .y = path[index].y,
                .speed_x = tx / tt,
                .speed_y = ty / tt,
                .deviation = deviation / std::sqrt(tt)};
}

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
  // a velocity at either end may be that of a touch
  const double begin = moments.front().at + kWindow, end = moments.back().at - kWindow;
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
    const double across = first.speed_x * moment.speed_y - first.speed_y * moment.speed_x;
    const double along = first.speed_x * moment.speed_x + first.speed_y * moment.speed_y;
    const double turn = kTurn + kDoubt * moment.deviation / moment.speed();
    return std::abs(std::atan2(across, along)) < turn &&
           moment.speed() < least_ + kFaster + kDoubt * moment.deviation &&
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
  RollFinder finder(truth, recording);
  for (std::size_t i = 0; i < truth.ball.size(); ++i) {
    const auto moment = moment_at(truth.ball, i, truth.ball_deviation);
    if (moment && moment->speed() >= kLeastSpeed && !is_touched(truth, truth.ball[i]))
      finder.add(*moment);
    else
      finder.end();
  }
  finder.end();
  return std::move(finder).rolls();
}

}  // namespace robot::fit
