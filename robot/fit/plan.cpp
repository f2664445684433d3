#include "robot/fit/plan.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

#include "robot/core/text.h"
#include "robot/fit/ball_distance/ball_distance.h"
#include "robot/fit/rolling/rolling.h"

namespace robot::fit {
namespace {

// a ball's range is uncertain by as much as its deceleration; a kick's speed deviates by more (sim/data/models/match.json)
constexpr double kRollingWanted = 0.05;
// four halves of RoboCup 2019: 0.085 m/s² between rolls around 0.33 m/s²
constexpr double kSpreadOfRolls = 0.26;
constexpr double kDistanceWanted = 0.03;
constexpr std::size_t kPassesWanted = 5;
constexpr double kKickWanted = 0.1;                          // of the range: 5 % of the speed
constexpr std::size_t kKicksWanted = 50;                     // scripts/bench fit
constexpr std::array kRanges{0.3, 0.5, 1.0, 2.0, 3.0, 4.5};  // [m]

/// Returns the events that an interval of the wanted width takes: it shrinks with the square root of their number.
std::size_t events_for(std::size_t events, double loose, double wanted) {
  return static_cast<std::size_t>(std::ceil(static_cast<double>(events) * std::pow(loose / wanted, 2)));
}

Need rolling_need(const Evidence& evidence) {
  Need need{.figure = "ball.deceleration", .kind = "free rolls", .wanted = kRollingWanted};
  std::size_t enough = events_for(1, two_sided(100) * kSpreadOfRolls, kRollingWanted);
  if (const auto fit = fit_rolling(evidence)) {
    const Figure& figure = fit->deceleration;
    need.events = figure.events;
    need.loose = (figure.high - figure.low) / 2 / figure.value;
    enough = events_for(need.events, need.loose, kRollingWanted);
  } else {
    for (const auto& game : evidence.games) need.events += rolls_in(game->record, 0).size();
  }
  need.more = enough - std::min(enough, need.events);
  if (need.more > 0) need.advice = "roll the ball by hand over the empty field, slow and fast, in all directions";
  return need;
}

/// Returns the number of passes with an image in a range of true distances.
std::size_t passes_in(const std::vector<BallSize>& sizes, const std::vector<Group>& passes, double from, double to) {
  const auto is_inside = [&](std::size_t i) { return sizes[i].distance >= from && sizes[i].distance < to; };
  return static_cast<std::size_t>(
      std::ranges::count_if(passes, [&](const Group& pass) { return std::ranges::any_of(pass, is_inside); }));
}

/// Returns half the interval of the curve at a distance, as a share of the distance, or 0 outside the curve.
double looseness_at(const BallDistance& fit, double distance) {
  const auto nearest = std::ranges::min_element(
      fit.curve, {}, [&](const CurvePoint& point) { return std::abs(point.distance - distance); });
  const bool is_known = fit.figures[0].domain.from <= distance && distance <= fit.figures[0].domain.to;
  return is_known && nearest->distance > 0 ? (nearest->high - nearest->low) / 2 / nearest->distance : 0;
}

void add_distance_needs(const Evidence& evidence, std::vector<Need>& needs) {
  const BallSizes seen = read_ball_sizes(evidence);
  const std::vector<Group> passes = passes_of(seen.sizes);
  const auto fit = fit_ball_distance(seen);
  for (std::size_t i = 0; i + 1 < kRanges.size(); ++i) {
    Need need{.figure = formatted("ball distance at %.1f-%.1f m", kRanges[i], kRanges[i + 1]),
              .kind = "passes",
              .events = passes_in(seen.sizes, passes, kRanges[i], kRanges[i + 1]),
              .wanted = kDistanceWanted};
    if (fit) need.loose = looseness_at(*fit, (kRanges[i] + kRanges[i + 1]) / 2);
    const std::size_t enough = std::max(kPassesWanted, events_for(need.events, need.loose, kDistanceWanted));
    need.more = enough - std::min(enough, need.events);
    if (need.more > 0) need.advice = "let the robot walk to the ball and away from it at this distance";
    needs.push_back(std::move(need));
  }
}

/// Adds a need for each kind of kick that the robots know, which is what they did so far.
void add_kick_needs(const Evidence& evidence, const KickFacts& facts, std::vector<Need>& needs) {
  std::vector<std::string> recordings;
  for (KickFit& seen : seen_kicks(evidence, facts, recordings)) {
    Need need{.figure = "kicks." + seen.kind + ".range",
              .kind = "kicks",
              .events = seen.kicks.size(),
              .wanted = kKickWanted,
              .advice = {}};
    std::size_t enough = kKicksWanted;
    if (const auto fit = fit_kind(std::move(seen), recordings, facts)) {
      const Figure& range = fit->figures.front();
      need.events = range.events;
      need.loose = (range.high - range.low) / 2 / range.value;
      enough = events_for(need.events, need.loose, kKickWanted);
    }
    need.more = enough - std::min(enough, need.events);
    if (need.more > 0)
      need.advice = "put the ball before its foot on an empty field, let it kick, and repeat with both feet";
    needs.push_back(std::move(need));
  }
}

/// Formats half an interval: "± 3.1 %", "± 0.012 m/s", or "-" if it is not known.
std::string width_of(double half, const std::string& unit) {
  if (half == 0) return "-";
  if (unit == "%") return formatted("± %.1f %%", 100 * half);
  return formatted("± %.2g %s", half, unit.c_str());
}

}  // namespace

std::vector<Need> plan(const Evidence& evidence, const KickFacts& facts) {
  std::vector<Need> needs;
  add_distance_needs(evidence, needs);
  needs.push_back(rolling_need(evidence));
  add_kick_needs(evidence, facts, needs);
  return needs;
}

std::string to_text(const std::vector<Need>& needs) {
  std::string text =
      formatted("%-38s %8s %-22s %12s %12s %6s\n", "figure", "recorded", "", "known to", "wanted", "more");
  for (const Need& need : needs)
    text += formatted("%-38s %8zu %-22s %12s %12s %6s  %s\n", need.figure.c_str(), need.events, need.kind.c_str(),
                      width_of(need.loose, need.unit).c_str(), width_of(need.wanted, need.unit).c_str(),
                      need.more > 0 ? formatted("%zu", need.more).c_str() : "enough", need.advice.c_str());
  return text;
}

}  // namespace robot::fit
