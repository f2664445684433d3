#include "robot/fit/kicks/tracked_kick.h"

#include <algorithm>
#include <cmath>
#include <optional>
#include <utility>
#include <vector>

#include "robot/fit/math/angles.h"
#include "robot/fit/math/least_squares.h"

namespace robot::fit {
namespace {

constexpr double kBefore = 0.3;      // [s] before the begin, in which the ball must lie
constexpr double kLongest = 2.5;     // [s] after the begin
constexpr double kEnough = 0.3;      // [s] that must be seen after the touch
constexpr double kOther = 0.5;       // [m] from another robot to the ball: it may touch it
constexpr double kAgain = 0.3;       // [m] from the robot to the ball after its kick: it may touch it again
constexpr double kJump = 0.3;        // [m] between two images: the ball was placed elsewhere
constexpr double kLongestGap = 0.2;  // [s] between two images
constexpr std::size_t kFewest = 12;  // images
constexpr double kFastest = 8;       // [m/s]

/// Returns the distance [m] of a robot to the ball, infinite where the truth does not have the robot.
double distance_to(const lab::Path& robot, const lab::PlaceAt& ball) {
  const auto place = lab::place_at(robot, ball.at);
  return place ? std::hypot(place->x - ball.x, place->y - ball.y) : INFINITY;
}

/// Reports whether another robot than the kicker is near the ball.
bool is_disturbed(const lab::TruthRecord& truth, const lab::Path& own, const lab::PlaceAt& ball) {
  const auto kicker = lab::place_at(own, ball.at);
  return std::ranges::any_of(truth.robots, [&](const lab::TrueRobotPath& robot) {
    const auto place = lab::place_at(robot.path, ball.at);
    if (!place) return false;
    const bool is_kicker = kicker && std::hypot(place->x - kicker->x, place->y - kicker->y) < 0.1;
    return !is_kicker && std::hypot(place->x - ball.x, place->y - ball.y) < kOther;
  });
}

/// Returns the images of the ball around a kick, until somebody may touch it again.
std::vector<lab::PlaceAt> ball_around(const lab::TruthRecord& truth, const lab::Path& own, const KickRun& run) {
  std::vector<lab::PlaceAt> balls;
  auto next = std::ranges::lower_bound(truth.ball, run.begin - kBefore, {}, &lab::PlaceAt::at);
  for (; next != truth.ball.end() && next->at < run.begin + kLongest; ++next) {
    if (!balls.empty()) {
      const lab::PlaceAt& last = balls.back();
      if (next->at - last.at > kLongestGap || std::hypot(next->x - last.x, next->y - last.y) > kJump) break;
    }
    if (is_disturbed(truth, own, *next) || (next->at > run.end && distance_to(own, *next) < kAgain)) break;
    balls.push_back(*next);
  }
  return balls;
}

/// The way of a ball that is kicked with `speed` after a time [s].
double way_after(double speed, double deceleration, double time) {
  const double rolls = std::clamp(time, 0., speed / deceleration);
  return speed * rolls - deceleration * rolls * rolls / 2;
}

/// Parameters of the fit: time of the touch, velocity after it, place before it.
enum Parameter : std::size_t { touch, velocity_x, velocity_y, rest_x, rest_y };

LeastSquares problem_of(const std::vector<lab::PlaceAt>& balls, const KickRun& run, double deceleration,
                        double deviation) {
  const auto residuals = [&balls, deceleration, deviation](const Vector& p, Vector& errors) {
    const double speed = std::max(1e-9, std::hypot(p[velocity_x], p[velocity_y]));
    errors.resize(2 * balls.size());
    for (std::size_t i = 0; i < balls.size(); ++i) {
      const double way = way_after(speed, deceleration, balls[i].at - p[touch]);
      errors[2 * i] = (balls[i].x - p[rest_x] - way * p[velocity_x] / speed) / deviation;
      errors[2 * i + 1] = (balls[i].y - p[rest_y] - way * p[velocity_y] / speed) / deviation;
    }
  };
  return {.least = {run.begin - 0.1, -kFastest, -kFastest, -100, -100},
          .most = {run.begin + kLongest, kFastest, kFastest, 100, 100},
          .residuals = residuals,
          .loss = Loss::cauchy};
}

/// Returns a start for the fit, or nothing if the ball did not move.
std::optional<Vector> start_of(const std::vector<lab::PlaceAt>& balls, double begin, double deviation) {
  double x = 0, y = 0, count = 0;
  for (const lab::PlaceAt& ball : balls)
    if (ball.at < begin) x += ball.x, y += ball.y, count += 1;
  if (count == 0) return std::nullopt;
  x /= count, y /= count;
  const auto far_from_rest = [&](const lab::PlaceAt& ball) {
    return std::hypot(ball.x - x, ball.y - y) > 3 * deviation;
  };
  // one image may err; the ball is gone in all that follow
  const auto last_at_rest = std::find_if_not(balls.rbegin(), balls.rend(), far_from_rest).base();
  if (last_at_rest == balls.end()) return std::nullopt;
  const auto later = std::min(balls.end() - 1, last_at_rest + 6);
  const double time = std::max(0.1, later->at - last_at_rest->at + 0.05);
  return Vector{std::max(begin, last_at_rest->at - 0.05), (later->x - x) / time, (later->y - y) / time, x, y};
}

bool is_moving_before(const std::vector<lab::PlaceAt>& balls, double begin, double deviation) {
  std::vector<lab::PlaceAt> before;
  std::ranges::copy_if(balls, std::back_inserter(before), [&](const lab::PlaceAt& ball) { return ball.at < begin; });
  if (before.size() < 4) return true;
  const std::size_t half = before.size() / 2;
  double x = 0, y = 0;
  for (std::size_t i = 0; i < half; ++i) {
    const lab::PlaceAt &late = before[before.size() - 1 - i], &early = before[i];
    x += (late.x - early.x) / static_cast<double>(half);
    y += (late.y - early.y) / static_cast<double>(half);
  }
  return std::hypot(x, y) > 0.02 + 3 * deviation * std::sqrt(2. / static_cast<double>(half));
}

}  // namespace

std::variant<TrackedKick, Untold> tracked(const lab::TruthRecord& truth, const lab::Path& own, const KickRun& run,
                                          const KickKind& kind, double deceleration) {
  const double deviation = truth.ball_deviation, side = run.left ? 1 : -1;
  const std::vector<lab::PlaceAt> balls = ball_around(truth, own, run);
  const auto robot = lab::place_at(own, run.begin);
  if (balls.size() < kFewest || !robot || !std::isfinite(robot->heading) ||
      is_moving_before(balls, run.begin, deviation))
    return Untold::disturbed;
  const auto start = start_of(balls, run.begin, deviation);
  if (!start) return balls.back().at > run.end - kLongestGap ? Untold::missed : Untold::disturbed;

  const LeastSquares problem = problem_of(balls, run, deceleration, deviation);
  const Solution solution = minimise(problem, *start);
  const Vector& p = solution.parameters;
  const auto deviations = parameter_deviations(problem, p);
  if (!deviations || balls.back().at < p[touch] + kEnough) return Untold::disturbed;

  const auto kicker = lab::place_at(own, p[touch]);
  if (!kicker || !std::isfinite(kicker->heading)) return Untold::disturbed;
  const double c = std::cos(kicker->heading), s = std::sin(kicker->heading);
  const double to_x = p[rest_x] - kicker->x, to_y = p[rest_y] - kicker->y;
  const double ahead = c * to_x + s * to_y, left = side * (c * to_y - s * to_x);
  if (std::abs(ahead - kind.ball_x) > kind.gate_x || std::abs(left - kind.ball_y) > kind.gate_y)
    return Untold::out_of_place;

  const double speed = std::hypot(p[velocity_x], p[velocity_y]);
  const double ux = p[velocity_x] / speed, uy = p[velocity_y] / speed;
  return TrackedKick{
      .recording = 0,
      .at = p[touch],
      .delay = p[touch] - run.begin,
      .speed = speed,
      .speed_deviation = std::hypot(ux * (*deviations)[velocity_x], uy * (*deviations)[velocity_y]),
      .direction = side * wrapped(std::atan2(p[velocity_y], p[velocity_x]) - kicker->heading),
      .direction_deviation = std::hypot(uy * (*deviations)[velocity_x], ux * (*deviations)[velocity_y]) / speed};
}

}  // namespace robot::fit
