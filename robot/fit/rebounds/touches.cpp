#include "robot/fit/rebounds/touches.h"

#include <algorithm>
#include <cmath>
#include <optional>

#include "robot/fit/math/least_squares.h"
#include "robot/fit/mean_path.h"

namespace robot::fit {
namespace {

constexpr double kSpan = 0.45;             // [s] of the ball's way before and after
constexpr double kLeastChange = 0.2;       // [m/s]
constexpr double kClear = 4;               // deviations of the change
constexpr double kNear = 0.5;              // [m] from a robot to the ball
constexpr double kRobotSpan = 0.25;        // [s] before and after, over which a robot's place and speed are measured
constexpr double kLongestPause = 0.15;     // [s] between two places of the ball
constexpr double kFastestJump = 8;         // [m/s] a faster ball was placed elsewhere
constexpr std::size_t kFewestRolling = 6;  // places before and after
constexpr double kBadFit = 2.5;            // mean square of the residuals, in errors of the truth
constexpr double kLatest = 0.2;            // [s] from the image with the greatest change to the touch
constexpr double kSame = 0.15;             // [s] between two touches that are one
constexpr double kPast = 0.3;              // [s] after the greatest change: what follows is another touch
constexpr double kRollsFrom = 0.1;         // [m/s] a slower ball lies, or is about to

using Places = std::vector<lab::PlaceAt>;

/// A range of places, of which the ball was seen without a pause.
struct Span {
  std::size_t first, end;
};

/// Returns the places up to kSpan before (or from kSpan after) a place, which belongs to neither.
Span span_before(const Places& places, std::size_t middle) {
  std::size_t first = middle;
  while (first > 0 && places[middle].at - places[first - 1].at <= kSpan &&
         places[first].at - places[first - 1].at <= kLongestPause)
    --first;
  return {first, middle};
}

Span span_after(const Places& places, std::size_t middle) {
  std::size_t end = middle + 1;
  while (end < places.size() && places[end].at - places[middle].at <= kSpan &&
         places[end].at - places[end - 1].at <= kLongestPause)
    ++end;
  return {middle + 1, end};
}

/// The straight line through places.
struct Line {
  double x = 0, y = 0;  // [m/s] its velocity
  double at = 0, middle_x = 0, middle_y = 0;
  double deviation = 0;  // [m/s] for places with an error of 1 m
};

Line line_through(const Places& places, Span span) {
  Line line;
  const auto count = static_cast<double>(span.end - span.first);
  for (std::size_t i = span.first; i < span.end; ++i)
    line.at += places[i].at / count, line.middle_x += places[i].x / count, line.middle_y += places[i].y / count;
  double tt = 0, tx = 0, ty = 0;
  for (std::size_t i = span.first; i < span.end; ++i) {
    const double t = places[i].at - line.at;
    tt += t * t, tx += t * (places[i].x - line.middle_x), ty += t * (places[i].y - line.middle_y);
  }
  line.x = tx / tt, line.y = ty / tt, line.deviation = 1 / std::sqrt(tt);
  return line;
}

/// The change of the ball's velocity around one of its places.
struct Change {
  Span before{}, after{};
  Line in, out;
  double size = 0;  // [m/s]
};

std::optional<Change> change_at(const Places& places, std::size_t middle, double error) {
  Change change{.before = span_before(places, middle), .after = span_after(places, middle), .in = {}, .out = {}};
  if (change.before.end - change.before.first < kFewestRolling ||
      change.after.end - change.after.first < kFewestRolling)
    return std::nullopt;
  change.in = line_through(places, change.before), change.out = line_through(places, change.after);
  change.size = std::hypot(change.out.x - change.in.x, change.out.y - change.in.y);
  const double deviation = error * std::hypot(change.in.deviation, change.out.deviation);
  if (change.size < std::max(kLeastChange, kClear * deviation)) return std::nullopt;
  return change;
}

/// The way of a ball that has a speed at time 0. Before that it was faster; after it, it stops.
double way_of_ball(double speed, double deceleration, double time) {
  if (time < 0) {
    const double rolls = speed * speed / (speed * speed + kRollsFrom * kRollsFrom);
    return speed * time - rolls * deceleration * time * time / 2;
  }
  const double rolling = std::min(time, speed / deceleration);
  return speed * rolling - deceleration * rolling * rolling / 2;
}

/// Parameters of the fit. The moment is that after the image with the greatest change [s].
enum Meeting : std::size_t { moment, place_x, place_y, in_x, in_y, out_x, out_y };

LeastSquares meeting_of(const Places& places, const Change& change, double at, double deceleration, double error) {
  const std::size_t first = change.before.first, count = change.after.end - first;
  const auto residuals = [&places, first, count, at, deceleration, error](const Vector& p, Vector& errors) {
    errors.resize(2 * count);
    const double in = std::max(1e-9, std::hypot(p[in_x], p[in_y])),
                 out = std::max(1e-9, std::hypot(p[out_x], p[out_y]));
    for (std::size_t i = 0; i < count; ++i) {
      const lab::PlaceAt& place = places[first + i];
      const double time = place.at - at - p[moment];
      const double speed = time < 0 ? in : out, way = way_of_ball(speed, deceleration, time) / speed;
      errors[2 * i] = (place.x - p[place_x] - way * (time < 0 ? p[in_x] : p[out_x])) / error;
      errors[2 * i + 1] = (place.y - p[place_y] - way * (time < 0 ? p[in_y] : p[out_y])) / error;
    }
  };
  return {.least = {-kLatest, -100, -100, -10, -10, -10, -10},
          .most = {kLatest, 100, 100, 10, 10, 10, 10},
          .residuals = residuals,
          .loss = Loss::cauchy};
}

/// Returns the robot at a moment, or nothing if the truth does not have it, or if it is far from the ball.
std::optional<Toucher> toucher_at(const std::string& name, const MeanPath& path, const Touch& touch, double error) {
  const auto here = path.over(touch.at - kRobotSpan, touch.at + kRobotSpan);
  if (!here || std::hypot(here->x - touch.x, here->y - touch.y) > 2 * kNear) return std::nullopt;
  const auto slope = path.slope_over(touch.at - kRobotSpan, touch.at + kRobotSpan);
  const auto drift = path.slope_over(touch.at - 2 * kRobotSpan, touch.at + 2 * kRobotSpan);
  if (!slope || !drift) return std::nullopt;
  const double later = touch.at - here->at;
  const double of_mean = 1 / std::sqrt(static_cast<double>(here->places));
  Toucher toucher{.robot = name,
                  .x = here->x + later * slope->x,
                  .y = here->y + later * slope->y,
                  .deviation = error * std::hypot(of_mean, later * slope->deviation),
                  .speed_x = slope->x,
                  .speed_y = slope->y,
                  .speed_deviation = error * slope->deviation,
                  .drift_x = drift->x,
                  .drift_y = drift->y,
                  .drift_deviation = error * drift->deviation};
  if (std::hypot(toucher.x - touch.x, toucher.y - touch.y) > kNear) return std::nullopt;
  const auto place = lab::place_at(path.places(), touch.at);
  toucher.fallen = place && place->fallen.value_or(false);
  return toucher;
}

/// Finds the touches of one game.
class TouchFinder {
 public:
  TouchFinder(const lab::TruthRecord& truth, double deceleration, std::size_t recording)
      : truth_(truth), ball_(truth.ball), deceleration_(deceleration), recording_(recording) {
    for (const lab::TrueRobotPath& robot : truth.robots) robots_.emplace_back(robot.path);
  }

  TouchesSeen found() && {
    const Places& places = ball_.places();
    seen_.left_out = ball_.left_out();
    std::optional<Change> greatest;
    std::size_t where = 0;
    for (std::size_t i = 0; i < places.size(); ++i) {
      const auto change = change_at(places, i, truth_.ball_deviation);
      // a change shows in all images around it: the greatest one is nearest
      if (greatest && (!change || places[i].at - places[where].at > kPast)) refine(*greatest, where), greatest.reset();
      if (!change) continue;
      if (!greatest || change->size > greatest->size) greatest = change, where = i;
    }
    if (greatest) refine(*greatest, where);
    return std::move(seen_);
  }

 private:
  void refine(const Change& change, std::size_t where) {
    const Places& places = ball_.places();
    const double error = truth_.ball_deviation, at = places[where].at;
    const LeastSquares problem = meeting_of(places, change, at, deceleration_, error);
    const Line &in = change.in, &out = change.out;
    const Solution solution =
        minimise(problem, {0, (in.middle_x + (at - in.at) * in.x + out.middle_x + (at - out.at) * out.x) / 2,
                           (in.middle_y + (at - in.at) * in.y + out.middle_y + (at - out.at) * out.y) / 2, in.x, in.y,
                           out.x, out.y});
    const Vector& p = solution.parameters;
    const auto deviations = parameter_deviations(problem, p);
    Vector errors;
    problem.residuals(p, errors);
    double squares = 0;
    for (const double one : errors) squares += one * one;
    const auto freedom = static_cast<double>(errors.size()) - 7;
    if (!deviations || squares / freedom > kBadFit || std::abs(p[moment]) > 0.95 * kLatest) {
      ++seen_.unclear;
      return;
    }
    Touch touch{.recording = recording_,
                .at = at + p[moment],
                .x = p[place_x],
                .y = p[place_y],
                .deviation = std::hypot((*deviations)[place_x], (*deviations)[place_y]) / std::sqrt(2.),
                .before_x = p[in_x],
                .before_y = p[in_y],
                .after_x = p[out_x],
                .after_y = p[out_y],
                .before_deviation = std::hypot((*deviations)[in_x], (*deviations)[in_y]) / std::sqrt(2.),
                .after_deviation = std::hypot((*deviations)[out_x], (*deviations)[out_y]) / std::sqrt(2.),
                .lateness = (*deviations)[moment],
                .near = {}};
    if (std::max(std::hypot(touch.before_x, touch.before_y), std::hypot(touch.after_x, touch.after_y)) > kFastestJump) {
      ++seen_.unclear;
      return;
    }
    if (!seen_.touches.empty() && touch.at - seen_.touches.back().at < kSame) return;
    for (std::size_t i = 0; i < robots_.size(); ++i)
      if (auto toucher = toucher_at(truth_.robots[i].name, robots_[i], touch, error))
        touch.near.push_back(std::move(*toucher));
    std::ranges::sort(touch.near, {}, [&](const Toucher& one) { return std::hypot(one.x - touch.x, one.y - touch.y); });
    seen_.touches.push_back(std::move(touch));
  }

  const lab::TruthRecord& truth_;
  MeanPath ball_;
  const double deceleration_;
  const std::size_t recording_;
  std::vector<MeanPath> robots_;
  TouchesSeen seen_;
};

}  // namespace

TouchesSeen touches_in(const lab::TruthRecord& truth, double deceleration, std::size_t recording) {
  return TouchFinder(truth, deceleration, recording).found();
}

}  // namespace robot::fit
