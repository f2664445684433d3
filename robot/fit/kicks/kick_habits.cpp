#include "robot/fit/kicks/kick_habits.h"

#include <algorithm>
#include <cmath>

#include "robot/fit/math/counts.h"
#include "robot/fit/math/resampling.h"
#include "sim/statistics/sample.h"

namespace robot::fit {
namespace {

constexpr std::size_t kFewestDurations = 5, kFewestOfFoot = 8;
constexpr double kWidestDuration = 0.2;  // [s]
constexpr double kNormal = 1.96;         // standard deviations to either side that cover 95 %

Figure habit(const KickFit& fit, const char* name, const char* unit, std::size_t events) {
  const auto [slowest, fastest] = std::ranges::minmax_element(fit.kicks, {}, &TrackedKick::speed);
  return {.name = "kicks." + fit.kind + "." + name,
          .unit = unit,
          .events = events,
          .kind = "kicks",
          .recordings = {},
          .domain = {.quantity = "speed", .unit = "m/s", .from = slowest->speed, .to = fastest->speed}};
}

void add_duration(const KickFit& fit, std::vector<Figure>& figures) {
  if (fit.durations.size() < kFewestDurations) return;
  const double middle = sim::statistics::median(fit.durations);
  std::vector<double> apart;
  for (const double duration : fit.durations) apart.push_back(std::abs(duration - middle));
  const double deviation = deviation_of_median(sim::statistics::median(apart), apart.size());
  const double half = std::hypot(two_sided(apart.size() - 1) * deviation, fit.status_step);
  Figure figure = habit(fit, "duration", "s", apart.size());
  figure.value = middle, figure.low = middle - half, figure.high = middle + half;
  figure.widest = kWidestDuration;
  figures.push_back(std::move(figure));
}

void add_misses(const KickFit& fit, std::vector<Figure>& figures) {
  const auto count = static_cast<double>(fit.kicks.size() + fit.missed), missed = static_cast<double>(fit.missed);
  const CountInterval interval = wilson_interval(missed / count, count, kNormal);
  Figure figure = habit(fit, "missed", "", fit.kicks.size() + fit.missed);
  figure.value = missed / count, figure.low = interval.low, figure.high = interval.high;
  figures.push_back(std::move(figure));
}

void add_foot(const KickFit& fit, bool left, std::vector<Figure>& figures) {
  std::vector<double> directions;
  for (const TrackedKick& kick : fit.kicks)
    if (kick.left == left) directions.push_back(kick.direction);
  if (directions.size() < kFewestOfFoot) return;
  const double mean = sim::statistics::mean_of(directions);
  double squares = 0;
  for (const double direction : directions) squares += (direction - mean) * (direction - mean);
  const auto count = static_cast<double>(directions.size());
  const double half = two_sided(directions.size() - 1) * std::sqrt(squares / (count - 1) / count);
  Figure figure = habit(fit, left ? "direction_left" : "direction_right", "rad", directions.size());
  figure.value = mean, figure.low = mean - half, figure.high = mean + half;
  figures.push_back(std::move(figure));
}

}  // namespace

std::vector<Figure> habits_of(const KickFit& fit) {
  std::vector<Figure> figures;
  add_duration(fit, figures);
  add_misses(fit, figures);
  for (const bool left : {true, false}) add_foot(fit, left, figures);
  return figures;
}

}  // namespace robot::fit
