#include "robot/fit/walking/walking.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <set>
#include <utility>

#include "robot/core/text.h"
#include "robot/fit/math/resampling.h"
#include "robot/fit/walking/paces.h"

namespace robot::fit {
namespace {

using sim::motion::Walk;

constexpr double kTickDeviation = 1. / 30 / 3.4641;  // [s] the simulator rounds delays to whole ticks
constexpr std::size_t kFewestHalts = 6;
constexpr double kBrakeMargin = 0.05;     // [s] by which a halt outlasts its braking
constexpr double kShownPace = 100;        // curvature at which the drives show a robot's pace, not the prior
constexpr double kGridRounding = 0.0005;  // deviation of a logarithm that is known exactly
// One standard deviation of an acceleration as a share, beyond the scatter of drives. In simulated games with a truth of 2 cm
// accelerations came out 6 %, those of turning 4 % too high (scripts/bench fit). Drills show no such bias: in games, commands
// answer to the luck of steps.
constexpr double kMissedByMeanWalk = 0.05, kMissedByMeanTurn = 0.035;

/// A figure of the walk as people read it.
struct WalkFigure {
  const char* name;
  const char* unit;
  const char* kind;  // of its events
  double widest;     // half the interval, as a share of the value where `is_share`
  bool is_share;
  double wanted;  // likewise
  const char* advice;
};
constexpr std::array<WalkFigure, kWalkParts> kWalkTable{{
    {"walk.forward", "m/s", "seconds of walking ahead at full speed", 0.4, true, 0.05,
     "Let it walk 3 m straight ahead at full speed, with a stop before and after, again and again."},
    {"walk.backward", "m/s", "seconds of walking back at full speed", 0.4, true, 0.05,
     "Let it walk 2 m straight back at full speed (walk_speed), with a stop before and after."},
    {"walk.sideward", "m/s", "seconds of walking to a side at full speed", 0.4, true, 0.05,
     "Let it walk 2 m to the left and back to the right at full speed (walk_speed)."},
    {"walk.turn_rate", "rad/s", "seconds of turning at full rate", 0.15, true, 0.03,
     "Let it turn twice round on the spot at full rate, to both sides."},
    {"walk.turn_cost", "", "seconds of walking at full speed in a curve", 0.2, false, 0.05,
     "Let it walk in a curve at full speed with half the turn rate, to both sides."},
    {"walk.acceleration", "m/s²", "starts, stops and changes of speed", 0.3, true, 0.15,
     "Let it start to walk ahead at full speed, and stop after 2 s of walking."},
    {"walk.turn_acceleration", "rad/s²", "starts, stops and changes of turning", 0.4, true, 0.2,
     "Let it start to turn on the spot at full rate, and stop after 1 s."},
    {"walk.start_delay", "s", "starts", 0.1, false, 0.03,
     "Let it stand for 2 s, then start to walk ahead at full speed."},
}};

double student_of(double freedom) { return two_sided(static_cast<std::size_t>(std::max(1L, std::lround(freedom)))); }

/// Writes the figures of one fit into a report.
class WalkReport {
 public:
  WalkReport(const FittedWalk& fitted, const Drives& drives, const sim::Models& base, Report& report)
      : fit_(fitted.fit), luck_(fitted.luck), problem_(fitted.problem), drives_(drives), base_(base), report_(report) {
    find_paces();
    find_domains();
  }

  void add() {
    for (std::size_t i = 0; i < kWalkParts; ++i) add_part(static_cast<WalkPart>(i));
    add_stop_delay();
    add_luck_figure(luck_.speed, "walk.speed_noise", "", 0.05, 0.02);
    add_luck_figure(luck_.turn, "walk.turn_noise", "rad/s", 0.05, 0.02);
    add_spread();
    add_paces();
  }

 private:
  /// Finds the robots whose pace the drives show, and from them the pace of the fastest.
  void find_paces() {
    Vector curvature(fit_.free.size());
    for (const DriveEquations& one : fit_.equations)
      for (std::size_t k = 0; k < one.which.size(); ++k) curvature[one.which[k]] += one.curvature[k][k];
    for (std::size_t i = 0; i < fit_.state.robots(); ++i)
      if (fit_.free[kWalkParts + i] && curvature[kWalkParts + i] > kShownPace) paced_.push_back(i);
    if (paced_.size() < 2) paced_.clear();
    mean_.assign(fit_.free.size(), 0);
    for (const std::size_t robot : paced_) mean_[kWalkParts + robot] = 1 / static_cast<double>(paced_.size());
    Vector paces{0}, deviations{kGridRounding};
    if (!paced_.empty()) paces.clear(), deviations.clear();
    for (const std::size_t robot : paced_) {
      Vector beside = mean_;
      for (double& share : beside) share = -share;
      beside[kWalkParts + robot] += 1;
      paces.push_back(fit_.state.log_pace(robot));
      deviations.push_back(std::max(kGridRounding, fit_.deviation_of_sum(beside)));
    }
    const double known = base_.effects.walk_spread ? static_cast<double>(base_.motion.walk.spread) : 0;
    const bool shows_spread = paced_.size() >= kFewestPaces;
    fastest_ = fastest_of(paces, deviations, shows_spread ? std::nullopt : std::optional(known));
  }

  /// Finds the ranges of the true motion over seconds.
  void find_domains() {
    for (const DriveTrack& track : problem_.tracks)
      for (std::size_t i = 0; i + kBlocksASecond < track.blocks(); ++i) {
        if (track.places_in(i) < 2 || track.places_in(i + kBlocksASecond) < 2) continue;
        const BlockStep step = seen_between(track, i, i + kBlocksASecond);
        most_ahead_ = std::max(most_ahead_, step.ahead), most_back_ = std::max(most_back_, -step.ahead);
        most_aside_ = std::max(most_aside_, std::abs(step.left)),
        most_turn_ = std::max(most_turn_, std::abs(step.turn));
      }
  }

  Domain domain_of(WalkPart part) const {
    switch (part) {
      case kForward: return {.quantity = "speed ahead", .unit = "m/s", .from = 0, .to = most_ahead_};
      case kBackward: return {.quantity = "speed back", .unit = "m/s", .from = 0, .to = most_back_};
      case kSideward: return {.quantity = "speed to a side", .unit = "m/s", .from = 0, .to = most_aside_};
      case kTurnRate:
      case kTurnCost:
      case kTurnAcceleration: return {.quantity = "turn rate", .unit = "rad/s", .from = 0, .to = most_turn_};
      default: return {.quantity = "speed", .unit = "m/s", .from = 0, .to = std::max(most_ahead_, most_aside_)};
    }
  }

  Figure figure_of(const std::string& name, const std::string& unit, double value, double low, double high,
                   double events, const std::string& kind, const Domain& domain) const {
    return {.name = name,
            .unit = unit,
            .value = value,
            .low = low,
            .high = high,
            .events = static_cast<std::size_t>(events),
            .kind = kind,
            .recordings = drives_.robots,
            .domain = domain};
  }

  void add_part(WalkPart part) {
    const WalkFigure& as = kWalkTable[part];
    const double amount = fit_.shown[part].amount, enough = enough_of(part);
    if (!fit_.free[part]) {
      report_.kept.push_back(formatted("%s: expected at least %.0f %s in 3 drives, got %.1f in %zu", as.name, enough,
                                       as.kind, amount, fit_.shown[part].drives));
      report_.needs.push_back(
          need_of(as.name, as.kind, static_cast<std::size_t>(amount), static_cast<std::size_t>(3 * enough), as.advice));
      return;
    }
    const double t = student_of(fit_.freedom[part]);
    Figure figure = part <= kSideward                          ? speed_figure(part, t)
                    : part == kTurnCost || part == kStartDelay ? plain_figure(part, t)
                                                               : log_figure(part, t);
    figure.widest = as.widest * (as.is_share ? figure.value : 1);
    // more seconds of the same robots make their own speeds exact, not the fastest robot's
    Figure measured = figure;
    if (part <= kSideward) {
      const double half = t * deviation_of_speed(part) * figure.value;
      measured.low = figure.value - half, measured.high = figure.value + half;
    }
    report_.needs.push_back(need_of(measured, as.wanted * (as.is_share ? figure.value : 1), as.advice));
    report_.figures.push_back(std::move(figure));
  }

  /// Returns one standard deviation of the logarithm of the mean robot's speed.
  double deviation_of_speed(WalkPart part) const {
    Vector combination = mean_;
    combination[part] += 1;
    return std::max(kGridRounding, fit_.deviation_of_sum(combination));
  }

  Figure speed_figure(WalkPart part, double t) const {
    const WalkFigure& as = kWalkTable[part];
    const double half = t * deviation_of_speed(part), middle = fit_.state.parameters[part] + fastest_.log_pace.value;
    const double below = std::hypot(half, fastest_.log_pace.value - fastest_.log_pace.low);
    const double above = std::hypot(half, fastest_.log_pace.high - fastest_.log_pace.value);
    return figure_of(as.name, as.unit, std::exp(middle), std::exp(middle - below), std::exp(middle + above),
                     fit_.shown[part].amount, as.kind, domain_of(part));
  }

  Figure log_figure(WalkPart part, double t) const {
    const WalkFigure& as = kWalkTable[part];
    const double least = part == kAcceleration       ? kMissedByMeanWalk
                         : part == kTurnAcceleration ? kMissedByMeanTurn
                                                     : kGridRounding;
    const double middle = fit_.state.parameters[part], half = t * std::hypot(least, fit_.deviation(part));
    return figure_of(as.name, as.unit, std::exp(middle), std::exp(middle - half), std::exp(middle + half),
                     fit_.shown[part].amount, as.kind, domain_of(part));
  }

  Figure plain_figure(WalkPart part, double t) const {
    const WalkFigure& as = kWalkTable[part];
    const double rounding = part == kStartDelay ? kTickDeviation : kGridRounding;
    const double middle = fit_.state.parameters[part], half = t * std::hypot(rounding, fit_.deviation(part));
    const double most = part == kTurnCost ? 1 : INFINITY;
    return figure_of(as.name, as.unit, middle, std::max(0., middle - half), std::min(most, middle + half),
                     fit_.shown[part].amount, as.kind, domain_of(part));
  }

  void add_stop_delay() {
    const char* const advice = "Let it walk slowly (a third of full speed), and stop; again and again.";
    const double acceleration = fit_.state.value(kAcceleration), turning = fit_.state.value(kTurnAcceleration);
    Vector durations;
    double slowest = INFINITY, fastest = 0, resolution = 0;
    for (const Halt& halt : drives_.halts) {
      const double braking = std::max(halt.speed / acceleration, halt.turn_rate / turning);
      if (halt.duration < braking + kBrakeMargin + halt.resolution) continue;
      durations.push_back(halt.duration);
      resolution = std::max(resolution, halt.resolution);
      slowest = std::min(slowest, halt.speed), fastest = std::max(fastest, halt.speed);
    }
    if (durations.size() < kFewestHalts) {
      report_.kept.push_back(
          formatted("walk.stop_delay: expected at least %zu stops in motion_status (stopping, then "
                    "standing) that outlast the braking, got %zu of %zu",
                    kFewestHalts, durations.size(), drives_.halts.size()));
      report_.needs.push_back(need_of("walk.stop_delay", "slow stops", durations.size(), 3 * kFewestHalts, advice));
      return;
    }
    const double value = lab::median_of(durations);
    Vector away;
    for (const double duration : durations) away.push_back(std::abs(duration - value));
    const auto count = static_cast<double>(durations.size());
    const double deviation = deviation_of_median(lab::median_of(std::move(away)), durations.size());
    const double half = two_sided(durations.size() - 1) *
                        std::hypot(deviation, std::hypot(kTickDeviation, resolution / std::sqrt(12 * count)));
    report_.figures.push_back(figure_of("walk.stop_delay", "s", value, std::max(0., value - half), value + half, count,
                                        "stops",
                                        {.quantity = "speed before", .unit = "m/s", .from = slowest, .to = fastest}));
    report_.figures.back().widest = 0.1;
    report_.needs.push_back(need_of(report_.figures.back(), 0.05, advice));
  }

  void add_luck_figure(const std::optional<StepLuck>& luck, const char* name, const char* unit, double widest,
                       double wanted) {
    const char* const advice = "Let it walk straight for 5 s and longer at two thirds of full speed.";
    if (!luck) {
      report_.kept.push_back(formatted("%s: expected at least %zu seconds of steady walking in 4 drives, got %.1f",
                                       name, kFewestLucky, luck_.seconds));
      report_.needs.push_back(need_of(name, "seconds of steady walking", static_cast<std::size_t>(luck_.seconds),
                                      3 * kFewestLucky, advice));
      return;
    }
    report_.figures.push_back(figure_of(name, unit, luck->value, luck->low, luck->high,
                                        static_cast<double>(luck->seconds), "seconds of steady walking",
                                        domain_of(kAcceleration)));
    report_.figures.back().widest = widest;
    report_.needs.push_back(need_of(report_.figures.back(), wanted, advice));
  }

  void add_spread() {
    const char* const advice = "Let more robots walk 3 m straight ahead at full speed, five times each.";
    if (paced_.size() < kFewestPaces) {
      report_.kept.push_back(formatted("walk.spread: expected the pace of at least %zu robots, got %zu", kFewestPaces,
                                       std::max<std::size_t>(1, paced_.size())));
      report_.needs.push_back(need_of("walk.spread", "robots", std::max<std::size_t>(1, paced_.size()), 8, advice));
      return;
    }
    const Likely& spread = fastest_.spread;
    report_.figures.push_back(figure_of("walk.spread", "", spread.value, spread.low, spread.high,
                                        static_cast<double>(paced_.size()), "robots", domain_of(kForward)));
    report_.figures.back().widest = 0.25;
    report_.needs.push_back(need_of(report_.figures.back(), 0.15, advice));
  }

  /// Adds the speed of each robot.
  void add_paces() {
    if (!fit_.free[kForward] || paced_.empty()) return;
    Results results{.title = "Greatest speed ahead of each robot [m/s]",
                    .head = {"robot", "speed", "low", "high", "share of the fastest"},
                    .rows = {}};
    Picture picture{.title = "Each robot's greatest speed ahead",
                    .x_label = "robot",
                    .y_label = "speed [m/s]",
                    .axes = {.left = 0, .right = static_cast<double>(paced_.size()) + 1, .bottom = 0, .top = 0},
                    .marks = {}};
    Mark dots{.shape = Mark::Shape::dots, .role = Mark::Role::truth, .label = "robots", .x = {}, .y = {}, .high = {}};
    for (const std::size_t robot : paced_) {
      Vector combination(fit_.free.size());
      combination[kForward] = combination[kWalkParts + robot] = 1;
      const double middle = fit_.state.parameters[kForward] + fit_.state.log_pace(robot);
      const double half = student_of(fit_.freedom[kWalkParts + robot]) * fit_.deviation_of_sum(combination);
      const double share = std::exp(fit_.state.log_pace(robot) - fastest_.log_pace.value);
      results.rows.push_back({drives_.robots[robot], formatted("%.3f", std::exp(middle)),
                              formatted("%.3f", std::exp(middle - half)), formatted("%.3f", std::exp(middle + half)),
                              formatted("%.2f", share)});
      dots.x.push_back(static_cast<double>(dots.x.size()) + 1), dots.y.push_back(std::exp(middle));
      picture.axes.top = std::max(picture.axes.top, 1.2 * std::exp(middle));
    }
    const double top = std::exp(fit_.state.parameters[kForward] + fastest_.log_pace.value);
    const double slowest = top * (1 - fastest_.spread.value);
    picture.axes.top = std::max(picture.axes.top, 1.2 * top);
    const auto line = [&](double y, const char* label) {
      return Mark{.shape = Mark::Shape::line,
                  .role = Mark::Role::fitted,
                  .label = label,
                  .x = {0, picture.axes.right},
                  .y = {y, y},
                  .high = {}};
    };
    picture.marks = {line(top, "fastest and slowest"), line(slowest, ""), std::move(dots)};
    report_.results.push_back(std::move(results));
    report_.pictures.push_back(std::move(picture));
  }

  const WalkFit& fit_;
  const WalkLuck& luck_;
  const WalkProblem& problem_;
  const Drives& drives_;
  const sim::Models& base_;
  Report& report_;
  std::vector<std::size_t> paced_;  // robots whose pace is known; empty: one pace for all
  Vector mean_;                     // the combination of parameters that is their mean pace
  Fastest fastest_;
  double most_ahead_ = 0, most_back_ = 0, most_aside_ = 0, most_turn_ = 0;
};

std::string seen_text(const Drives& drives, double seconds) {
  return formatted(
      "%zu drives of %zu robots, %.0f s; left out: %.0f s with a kick, a fall, a penalty or another robot within half "
      "a metre, %zu damaged commands",
      drives.drives.size(), drives.robots.size(), seconds, drives.disturbed, drives.damaged);
}

/// Returns why there is nothing to fit.
std::string missing_text(const Drives& drives) {
  if (drives.without_heading > 0)
    return formatted("walk: expected true headings of robots, got none for %zu robots with commands",
                     drives.without_heading);
  if (drives.without_command > 0)
    return formatted("walk: expected the topic motion_command, got none from %zu robots", drives.without_command);
  return "walk: expected at least 3 drives of a robot that follows commands beside its true path, got 0";
}

}  // namespace

FittedWalk fitted_walk(const Drives& drives, const sim::Models& base) {
  FittedWalk fitted{.problem = walk_problem_of(drives), .fit = {}, .luck = {}};
  fitted.problem.robots_differ = base.effects.walk_spread;
  Walk walk = base.motion.walk;
  if (!base.effects.walk_noise) walk.speed_noise = 0, walk.turn_noise = 0;
  if (!base.effects.walk_delay) walk.start_delay = 0, walk.stop_delay = 0;
  fitted.fit = fit_walk(fitted.problem, walk);
  for (int round = 0; round < 2; ++round) {
    fitted.luck = measure_luck(fitted.problem, fitted.fit);
    const double speed = fitted.luck.speed ? fitted.luck.speed->value : static_cast<double>(walk.speed_noise);
    const double turn = fitted.luck.turn ? fitted.luck.turn->value : static_cast<double>(walk.turn_noise);
    fitted.fit = refit_walk(fitted.problem, fitted.fit, speed, turn);
  }
  // an unknown luck may be half or one and a half times that of the models
  add_luck(fitted.problem, fitted.luck.speed ? fitted.luck.speed->deviation : 0.25 * walk.speed_noise,
           fitted.luck.turn ? fitted.luck.turn->deviation : 0.25 * walk.turn_noise, fitted.fit);
  return fitted;
}

Report fit_walking(const Drives& drives, const sim::Models& base) {
  Report report{.name = "walk", .title = "How the robots walk"};
  const std::string advice =
      "Let it walk 3 m ahead, back and to both sides, turn on the spot and walk in a curve, with stops between, for "
      "four minutes.";
  if (drives.drives.size() < 3) {
    report.kept.push_back(drives.drives.empty()
                              ? missing_text(drives)
                              : formatted("walk: expected at least 3 drives of a robot that follows commands "
                                          "beside its true path, got %zu",
                                          drives.drives.size()));
    report.needs.push_back(need_of("walk", "drives of 20 s", drives.drives.size(), 12, advice));
    return report;
  }
  const FittedWalk fitted = fitted_walk(drives, base);
  double seconds = 0;
  for (const DriveTrack& track : fitted.problem.tracks) seconds += static_cast<double>(track.blocks()) * kBlockDuration;
  report.notes.push_back(seen_text(drives, seconds));
  report.notes.push_back(formatted("errors of the truth by its scatter: %.1f cm of places, %.1f° of headings",
                                   100 * drives.place_deviation, drives.heading_deviation * 57.29578));
  add_walk_pictures(fitted, base, report);
  WalkReport(fitted, drives, base, report).add();
  add_walk_results(fitted, drives, base, report);
  return report;
}

Report fit_walking(const Evidence& evidence, const sim::Models& base) {
  return fit_walking(read_drives(evidence), base);
}

}  // namespace robot::fit
