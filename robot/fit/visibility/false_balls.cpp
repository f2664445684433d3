#include "robot/fit/visibility/false_balls.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "robot/core/text.h"
#include "robot/fit/math/angles.h"
#include "robot/fit/math/counts.h"

namespace robot::fit {
namespace {

constexpr double kNearestFalse = 0.3;              // [m] as in sim/perception/ball_sight.cpp
constexpr double kGoesOn = 0.15;                   // [s] a false ball in images that near is the same one
constexpr double kLeastExposure = 60;              // [s]
constexpr double kWidest = 0.01, kWidestOf = 0.5;  // [1/s], and of the value
constexpr std::size_t kMostTrueDots = 1000;
constexpr double kEnough = 0.005;  // [1/s]
constexpr const char* kFalseAdvice = "let the robots play, with their headings in the truth";

double overlap(double from, double to, double low, double high) {
  return std::max(0., std::min(to, high) - std::max(from, low));
}

/// Returns the share of the false places that a robot would see and that would be noticed.
double noticed_share(const Look& look, const SightCounts& places, double far_range) {
  const double low = std::max(kNearestFalse, look.nearest), high = std::min(far_range, look.farthest);
  const double whole = far_range - kNearestFalse;
  if (!(high > low) || !(whole > 0) || !(look.width > 0)) return 0;
  const double off = wrapped(places.bearing - look.axis);
  const double beside = overlap(off - places.reach, off + places.reach, -look.width / 2, look.width / 2) / look.width;
  const double along = overlap(places.nearest, places.farthest, low, high);
  return (high - low - beside * along) / whole;
}

FalseBall ball_of(const Look& look) {
  return {.recording = look.recording,
          .at = look.at,
          .x = look.seen_x,
          .y = look.seen_y,
          .true_x = look.distance * std::cos(look.bearing),
          .true_y = look.distance * std::sin(look.bearing)};
}

/// Leaves about `most` of the balls.
void thin(std::vector<FalseBall>& balls, std::size_t most) {
  const std::size_t step = balls.size() / most + 1;
  std::size_t kept = 0;
  for (std::size_t i = 0; i < balls.size(); i += step) balls[kept++] = balls[i];
  balls.resize(kept);
}

Picture picture_of(const FalseBalls& found, double far_range) {
  Mark seen{.shape = Mark::Shape::dots, .role = Mark::Role::truth, .label = "true balls, as seen"};
  Mark wrong{.shape = Mark::Shape::dots, .role = Mark::Role::fitted, .label = "false balls"};
  for (const FalseBall& ball : found.seen) seen.x.push_back(ball.x), seen.y.push_back(ball.y);
  for (const FalseBall& ball : found.balls) wrong.x.push_back(ball.x), wrong.y.push_back(ball.y);
  Picture picture{.title = "Where false balls appear, beside true ones",
                  .x_label = "ahead of the robot [m]",
                  .y_label = "to its left [m]",
                  .axes = {.left = -far_range, .right = far_range, .bottom = -far_range, .top = far_range}};
  picture.marks = {std::move(seen), std::move(wrong)};
  return picture;
}

Table table_of(const FalseBalls& found, const std::vector<std::string>& recordings) {
  Table table{
      .columns = {"time [s]", "seen x [m]", "seen y [m]", "true x [m]", "true y [m]"}, .names = recordings, .rows = {}};
  for (const FalseBall& ball : found.balls)
    table.rows.push_back({.recording = ball.recording, .values = {ball.at, ball.x, ball.y, ball.true_x, ball.true_y}});
  return table;
}

Figure rate_of(const FalseBalls& found, const Looks& looks, const sim::Models& base) {
  const auto all = static_cast<double>(found.balls.size());
  const auto groups = static_cast<std::size_t>(std::ranges::count(found.balls, true, &FalseBall::first));
  const CountInterval mean = poisson_interval(groups);
  const double each = (groups == 0 ? 1 : all / static_cast<double>(groups)) / found.exposure;
  const double value = all / found.exposure;
  return {.name = "ball_filter.false_per_second",
          .unit = "1/s",
          .value = value,
          .low = each * mean.low,
          .high = each * mean.high,
          .events = groups,
          .kind = "false balls",
          .recordings = looks.recordings,
          .domain = {.quantity = "range", .unit = "m", .from = kNearestFalse, .to = base.perception.ball.far_range},
          .widest = std::max(kWidest, kWidestOf * value)};
}

Report report_without() { return {.name = "false_balls", .title = "Balls seen where there are none"}; }

Report kept_with(const std::string& reason) {
  Report report = report_without();
  report.kept.push_back("ball_filter.false_per_second: " + reason);
  report.needs.push_back(need_of("ball_filter.false_per_second", "false balls", 0, 20, kFalseAdvice));
  return report;
}

}  // namespace

FalseBalls false_balls_in(const Looks& looks, const sim::Models& base) {
  const SightNoise noise = noise_of(looks, base);
  FalseBalls found;
  for (const Look& look : looks.looks) {
    const SightCounts places = ball_places(look, noise);
    if (look.has_ball && places.contain(look.seen_x, look.seen_y)) {
      found.seen.push_back(ball_of(look));
      continue;
    }
    found.seconds += look.duration;
    found.exposure += look.duration * noticed_share(look, places, base.perception.ball.far_range);
    if (!look.has_ball) continue;
    FalseBall ball = ball_of(look);
    if (!found.balls.empty()) {
      const FalseBall& last = found.balls.back();
      ball.first = last.recording != ball.recording || ball.at > last.at + kGoesOn;
    }
    found.balls.push_back(ball);
  }
  thin(found.seen, kMostTrueDots);
  return found;
}

Report false_balls_of(const Looks& looks, const sim::Models& base) {
  if (looks.looks.empty()) return kept_with(reason_without(looks));
  const FalseBalls found = false_balls_in(looks, base);
  if (found.exposure < kLeastExposure)
    return kept_with(formatted("expected at least %.0f seconds of images that show no true ball, got %.1f",
                               kLeastExposure, found.exposure));
  Report report = report_without();
  report.figures.push_back(rate_of(found, looks, base));
  report.pictures.push_back(picture_of(found, base.perception.ball.far_range));
  report.notes.push_back(formatted(
      "False balls: %zu in %.0f s of images without the true ball. In %.0f s of these a false ball would have been in "
      "the image and away from the true one.",
      found.balls.size(), found.seconds, found.exposure));
  report.notes.push_back(
      "Assumed, as in the simulator: false balls appear at any range and bearing in view alike, and only beside no "
      "true one.");
  report.notes.push_back(left_out(looks));
  report.tables.emplace_back("false_balls", table_of(found, looks.recordings));
  report.scores.emplace_back("false_balls_exposure_seconds", found.exposure);
  report.needs.push_back(
      need_of(report.figures.front(), std::max(kEnough, 0.3 * report.figures.front().value), kFalseAdvice));
  return report;
}

Report fit_false_balls(const Evidence& evidence, const sim::Models& base) {
  return false_balls_of(read_looks(evidence, base), base);
}

}  // namespace robot::fit
