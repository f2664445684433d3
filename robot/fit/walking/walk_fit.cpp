#include "robot/fit/walking/walk_fit.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "sim/motion/walk.h"

namespace robot::fit {
namespace {

using sim::motion::Walk;

constexpr double kPaceDeviation = 0.3;  // of the logarithm of a robot's pace, beside the mean robot's
constexpr int kMostDescents = 25, kFirstDescents = 3;
constexpr double kOutlyingStep = 4;       // [standard deviations] residuals beyond count less
constexpr double kSlopeStep = 0.02;       // of a logarithm, of the cost of turning
constexpr double kDelaySlopeStep = 0.01;  // [s]
constexpr double kSmallGain = 1e-3;       // of a standard deviation: a step that is not worth another round
constexpr double kFewestShowing = 3;
constexpr std::size_t kScanned = 60;  // drives of the search for a start

bool is_logarithm(std::size_t part) { return part < kWalkParts && part != kTurnCost && part != kStartDelay; }

float& walk_member_of(Walk& walk, WalkPart part) {
  switch (part) {
    case kForward: return walk.forward;
    case kBackward: return walk.backward;
    case kSideward: return walk.sideward;
    case kTurnRate: return walk.turn_rate;
    case kTurnCost: return walk.turn_cost;
    case kAcceleration: return walk.acceleration;
    case kTurnAcceleration: return walk.turn_acceleration;
    default: return walk.start_delay;
  }
}

struct WalkBounds {
  double least, most;
};
constexpr std::array<WalkBounds, kWalkParts> kWalkBounds{
    {{0.01, 3}, {0.01, 3}, {0.01, 3}, {0.05, 6}, {0, 1}, {0.05, 20}, {0.05, 60}, {0, 2}}};

double in_bounds(std::size_t parameter, double value) {
  if (parameter >= kWalkParts) return std::clamp(value, -2., 2.);
  const auto [least, most] = kWalkBounds[parameter];
  return is_logarithm(parameter) ? std::clamp(value, std::log(least), std::log(most)) : std::clamp(value, least, most);
}

double slope_step_of(std::size_t parameter, std::size_t robots) {
  if (parameter >= kWalkParts + robots || parameter == kStartDelay) return kDelaySlopeStep;
  // away from the upper bound
  return parameter == kTurnCost ? -kSlopeStep : kSlopeStep;
}

WalkState walk_state_of(const Walk& base, const std::vector<std::size_t>& clocks) {
  WalkState state{.parameters = Vector(kWalkParts + 2 * clocks.size()), .clocks = clocks};
  Walk walk = base;
  for (std::size_t i = 0; i < kWalkParts; ++i) {
    const double value = walk_member_of(walk, static_cast<WalkPart>(i));
    state.parameters[i] = is_logarithm(i) ? std::log(value) : value;
  }
  return state;
}

std::vector<BlockMean> predicted_path(const DriveTrack& track, const WalkState& state, const Walk& base) {
  const std::size_t robot = track.drive().robot;
  return track.predicted(mean_walk(state.walk_of(robot, base), track.drive().commands), state.late(robot));
}

bool both_seen(const DriveTrack& track, std::size_t block) {
  return track.places_in(block) >= 2 && track.places_in(block + 1) >= 2;
}

StepDeviation step_deviation_of(const WalkProblem& problem, const DriveTrack& track, const std::vector<BlockMean>& path,
                                std::size_t block, const Walk& walk) {
  const double shares =
      1. / static_cast<double>(track.places_in(block)) + 1. / static_cast<double>(track.places_in(block + 1));
  const double way = std::hypot(path[block + 1].x - path[block].x, path[block + 1].y - path[block].y);
  const double turn = std::abs(path[block + 1].heading - path[block].heading);
  const double steps = kBlockDuration / walk.step_duration;
  // the phase of the steps is not known: a change of the gait may come half a step earlier
  const double lucky = walk.speed_noise * way / std::sqrt(steps) + 0.02 * way;
  const bool walks = way > 0.005 || turn > 0.01;
  const double lucky_turn = (walks ? walk.turn_noise * kBlockDuration / std::sqrt(steps) : 0) + 0.02 * turn;
  return {.place = std::hypot(problem.place_deviation * std::sqrt(shares), std::hypot(lucky, 0.001)),
          .turn = std::hypot(problem.heading_deviation * std::sqrt(shares), std::hypot(lucky_turn, 0.002))};
}

/// Sets the deviations by the present state. They stay while it is fitted: weights that follow a residual would bias it.
void weigh_drives(const WalkProblem& problem, WalkFit& fit) {
  fit.deviations.clear();
  for (const DriveTrack& track : problem.tracks) {
    const std::vector<BlockMean> path = predicted_path(track, fit.state, fit.base);
    std::vector<StepDeviation> deviations(path.size() - 1);
    for (std::size_t i = 0; i + 1 < path.size(); ++i)
      if (both_seen(track, i)) deviations[i] = step_deviation_of(problem, track, path, i, fit.base);
    fit.deviations.push_back(std::move(deviations));
  }
}

/// Returns the weight of a residual. In the first rounds even the farthest count, since the model is what errs.
double step_weight_of(double residual, bool first) {
  const double far = std::abs(residual) / kOutlyingStep;
  if (far <= 1) return 1;
  return first ? 1 / far : far > 2 ? 0 : 1 / (far * far);
}

double step_loss_of(double residual) {
  const double far = std::abs(residual);
  return far <= kOutlyingStep ? far * far / 2 : kOutlyingStep * (far - kOutlyingStep / 2);
}

std::array<double, 3> in_deviations(const BlockStep& step, const StepDeviation& deviation) {
  return {step.ahead / deviation.place, step.left / deviation.place, step.turn / deviation.turn};
}

double cost_of_drive(const DriveTrack& track, const std::vector<StepDeviation>& deviations, const WalkState& state,
                     const Walk& base) {
  const std::vector<BlockMean> path = predicted_path(track, state, base);
  double cost = 0;
  for (std::size_t i = 0; i + 1 < path.size(); ++i) {
    if (!both_seen(track, i)) continue;
    const auto residuals = in_deviations(missed_between(track, path, i, i + 1), deviations[i]);
    for (const double residual : residuals) cost += step_loss_of(residual);
  }
  return cost;
}

/// Adds what a window shows of the speeds and of the cost of turning: the sensitivity of its motion.
void add_shown(const WalkState& state, const Walk& walk, std::size_t part, const BlockStep& moved, double step,
               Excitation& shown) {
  const double way = std::hypot(moved.ahead, moved.left) / std::abs(step), turn = std::abs(moved.turn / step);
  const auto seconds_if = [&](bool is) { shown.amount += is ? kBlockDuration : 0; };
  switch (part) {
    case kForward: seconds_if(way > 0.5 * walk.forward * kBlockDuration); break;
    case kBackward: seconds_if(way > 0.5 * walk.backward * kBlockDuration); break;
    case kSideward: seconds_if(way > 0.5 * walk.sideward * kBlockDuration); break;
    case kTurnRate: seconds_if(turn > 0.5 * state.value(kTurnRate) * kBlockDuration); break;
    case kTurnCost: seconds_if(way > 0.25 * walk.forward * kBlockDuration); break;
    case kAcceleration: shown.amount += std::min(1., way / (0.1 * walk.forward)) / 3; break;
    case kTurnAcceleration: shown.amount += std::min(1., turn / (0.05 * state.value(kTurnRate))) / 3; break;
    case kStartDelay: shown.amount += std::min(1., way / walk.forward + turn / state.value(kTurnRate)); break;
    default: break;
  }
}

DriveEquations equations_of(const WalkFit& fit, const DriveTrack& track, const std::vector<StepDeviation>& deviations,
                            bool first) {
  const WalkState& state = fit.state;
  const Walk& base = fit.base;
  const std::vector<bool>& free = fit.free;
  DriveEquations equations;
  const std::size_t robot = track.drive().robot, robots = state.robots();
  for (std::size_t i = 0; i < free.size(); ++i) {
    const bool other = i >= kWalkParts && i != kWalkParts + robot && i != state.late_index(robot);
    if (free[i] && !other) equations.which.push_back(i);
  }
  const std::size_t count = equations.which.size();
  equations.curvature.assign(count, Vector(count));
  equations.gradient.assign(count, 0);
  const Walk walk = state.walk_of(robot, base);
  const std::vector<BlockMean> path = predicted_path(track, state, base);
  std::vector<std::vector<BlockMean>> moved(count);
  for (std::size_t k = 0; k < count; ++k) {
    WalkState other = state;
    other.parameters[equations.which[k]] += slope_step_of(equations.which[k], robots);
    moved[k] = predicted_path(track, other, base);
  }
  std::vector<std::array<double, 3>> slopes(count);
  for (std::size_t i = 0; i + 1 < path.size(); ++i) {
    if (!both_seen(track, i)) continue;
    const StepDeviation& deviation = deviations[i];
    const BlockStep missed = missed_between(track, path, i, i + 1);
    const auto residuals = in_deviations(missed, deviation);
    for (std::size_t k = 0; k < count; ++k) {
      const BlockStep there = missed_between(track, moved[k], i, i + 1);
      const double step = slope_step_of(equations.which[k], robots);
      const BlockStep change{there.ahead - missed.ahead, there.left - missed.left, there.turn - missed.turn};
      slopes[k] = in_deviations({change.ahead / step, change.left / step, change.turn / step}, deviation);
      if (equations.which[k] < kWalkParts)
        add_shown(state, walk, equations.which[k], change, step, equations.shown[equations.which[k]]);
    }
    for (std::size_t part = 0; part < 3; ++part) {
      const double weight = step_weight_of(residuals[part], first);
      equations.cost += step_loss_of(residuals[part]);
      for (std::size_t k = 0; k < count; ++k) {
        equations.gradient[k] += weight * slopes[k][part] * residuals[part];
        for (std::size_t j = 0; j <= k; ++j) equations.curvature[k][j] += weight * slopes[k][part] * slopes[j][part];
      }
    }
  }
  for (std::size_t k = 0; k < count; ++k)
    for (std::size_t j = k + 1; j < count; ++j) equations.curvature[k][j] = equations.curvature[j][k];
  return equations;
}

/// The equations of all drives together, in the free parameters.
struct WalkSum {
  std::vector<std::size_t> place;  // of each parameter among the free ones
  std::vector<Vector> curvature;
  Vector gradient;
  double cost = 0;
};

/// One standard deviation of a parameter that is known before; 0: not known.
double known_deviation(const WalkProblem& problem, std::size_t robots, std::size_t parameter) {
  if (parameter < kWalkParts) return 0;
  if (parameter < kWalkParts + robots) return kPaceDeviation;
  return problem.clock_deviation[parameter - kWalkParts - robots];
}

WalkSum walk_sum_of(const WalkProblem& problem, const WalkFit& fit, const std::vector<bool>* left_out = nullptr) {
  WalkSum sum;
  std::size_t count = 0;
  for (const bool free : fit.free) sum.place.push_back(free ? count++ : 0);
  sum.curvature.assign(count, Vector(count));
  sum.gradient.assign(count, 0);
  for (std::size_t d = 0; d < fit.equations.size(); ++d) {
    if (left_out && (*left_out)[d]) continue;
    const DriveEquations& one = fit.equations[d];
    sum.cost += one.cost;
    for (std::size_t k = 0; k < one.which.size(); ++k) {
      sum.gradient[sum.place[one.which[k]]] += one.gradient[k];
      for (std::size_t j = 0; j < one.which.size(); ++j)
        sum.curvature[sum.place[one.which[k]]][sum.place[one.which[j]]] += one.curvature[k][j];
    }
  }
  for (std::size_t i = kWalkParts; i < fit.free.size(); ++i) {
    if (!fit.free[i]) continue;
    const double known = known_deviation(problem, fit.state.robots(), i), far = fit.state.parameters[i] / known;
    sum.curvature[sum.place[i]][sum.place[i]] += 1 / (known * known);
    sum.gradient[sum.place[i]] += far / known;
    sum.cost += far * far / 2;
  }
  return sum;
}

void form_equations(const WalkProblem& problem, bool first, WalkFit& fit) {
  fit.equations.clear();
  for (std::size_t i = 0; i < problem.tracks.size(); ++i)
    fit.equations.push_back(equations_of(fit, problem.tracks[i], fit.deviations[i], first));
}

/// Returns the cost of another state, of each drive or of some.
double walk_cost_of(const WalkProblem& problem, const WalkFit& fit, const WalkState& state, std::size_t every = 1) {
  double cost = 0;
  for (std::size_t i = 0; i < problem.tracks.size(); i += every)
    cost += cost_of_drive(problem.tracks[i], fit.deviations[i], state, fit.base);
  for (std::size_t i = kWalkParts; i < fit.free.size(); ++i)
    if (fit.free[i]) cost += std::pow(state.parameters[i] / known_deviation(problem, state.robots(), i), 2) / 2;
  return cost;
}

/// Returns the step that solves the equations, or nothing if they are singular.
std::optional<Vector> walk_step_by(const WalkSum& sum, double damping) {
  std::vector<Vector> curvature = sum.curvature;
  for (std::size_t i = 0; i < curvature.size(); ++i) curvature[i][i] += damping * curvature[i][i] + 1e-9;
  return solve(std::move(curvature), sum.gradient);
}

WalkState walk_stepped(const WalkFit& fit, const WalkSum& sum, const Vector& step) {
  WalkState next = fit.state;
  for (std::size_t i = 0; i < fit.free.size(); ++i)
    if (fit.free[i]) next.parameters[i] = in_bounds(i, next.parameters[i] - step[sum.place[i]]);
  return next;
}

/// Descends from the state of `fit` and leaves its equations at the end.
void descend_walk(const WalkProblem& problem, bool far, WalkFit& fit) {
  double damping = far ? 1e-3 : 0;
  for (int round = 0; round < kMostDescents; ++round) {
    form_equations(problem, far && round < kFirstDescents, fit);
    const WalkSum sum = walk_sum_of(problem, fit);
    WalkState next = fit.state;
    // a step that does not help is tried again, shorter
    bool helps = false;
    double gain = 0;
    for (int attempt = 0; attempt < 5 && !helps; ++attempt) {
      const auto step = walk_step_by(sum, damping);
      if (!step) return;
      next = walk_stepped(fit, sum, *step);
      gain = 0;
      for (std::size_t i = 0; i < step->size(); ++i) gain += (*step)[i] * sum.gradient[i];
      helps = gain < kSmallGain || walk_cost_of(problem, fit, next) <= sum.cost * (1 + 1e-9);
      damping = helps ? damping / 5 : std::max(1e-3, 10 * damping);
    }
    if (!helps || gain < kSmallGain) break;
    fit.state = next;
  }
  form_equations(problem, false, fit);
}

void count_shown(WalkFit& fit) {
  fit.shown = {};
  for (const DriveEquations& one : fit.equations)
    for (std::size_t i = 0; i < kWalkParts; ++i) {
      fit.shown[i].amount += one.shown[i].amount;
      fit.shown[i].drives += one.shown[i].amount >= 0.5 ? 1 : 0;
    }
}

/// Returns the covariance and the freedom, from the scatter of the drives' gradients.
void measure_walk(const WalkProblem& problem, WalkFit& fit) {
  const WalkSum sum = walk_sum_of(problem, fit);
  const std::size_t count = sum.gradient.size(), all = fit.free.size();
  std::vector<Vector> scatter(count, Vector(count));
  Vector total(count), squares(count);
  for (const DriveEquations& one : fit.equations)
    for (std::size_t k = 0; k < one.which.size(); ++k) {
      const std::size_t at = sum.place[one.which[k]];
      total[at] += one.curvature[k][k], squares[at] += one.curvature[k][k] * one.curvature[k][k];
      for (std::size_t j = 0; j < one.which.size(); ++j)
        scatter[at][sum.place[one.which[j]]] += one.gradient[k] * one.gradient[j];
    }
  fit.freedom.assign(all, 1);
  for (std::size_t i = 0; i < all; ++i)
    if (fit.free[i]) {
      const std::size_t at = sum.place[i];
      if (squares[at] > 0) fit.freedom[i] = std::max(1., total[at] * total[at] / squares[at] - 1);
      // the clocks' errors are what they are known to be, not what the drives seem to say
      if (i >= kWalkParts + fit.state.robots())
        scatter[at][at] += 1 / std::pow(known_deviation(problem, fit.state.robots(), i), 2);
    }
  std::vector<Vector> inverse;  // columns
  for (std::size_t i = 0; i < count; ++i) {
    Vector unit(count);
    unit[i] = 1;
    auto column = solve(sum.curvature, std::move(unit));
    inverse.push_back(column ? std::move(*column) : Vector(count, INFINITY));
  }
  fit.covariance.assign(all, Vector(all));
  for (std::size_t i = 0; i < all; ++i)
    for (std::size_t j = 0; j < all; ++j) {
      if (!fit.free[i] || !fit.free[j]) continue;
      double covariance = 0;
      for (std::size_t k = 0; k < count; ++k)
        for (std::size_t m = 0; m < count; ++m)
          covariance += inverse[sum.place[i]][k] * scatter[k][m] * inverse[sum.place[j]][m];
      fit.covariance[i][j] = covariance;
    }
}

/// Fixes the parameters that the drives do not show. Returns true if there were any.
bool fix_hidden(const Walk& base, WalkFit& fit) {
  const WalkState start = walk_state_of(base, fit.state.clocks);
  bool any = false;
  for (std::size_t i = 0; i < kWalkParts; ++i) {
    const bool shown = fit.shown[i].amount >= enough_of(static_cast<WalkPart>(i)) &&
                       static_cast<double>(fit.shown[i].drives) >= kFewestShowing;
    if (!fit.free[i] || shown) continue;
    fit.free[i] = false, any = true;
    fit.state.parameters[i] = start.parameters[i];
  }
  return any;
}

/// Looks for a start near which the cost is least, one parameter after the other.
void search_start(const WalkProblem& problem, WalkFit& fit) {
  const std::size_t every = problem.tracks.size() / kScanned + 1;
  weigh_drives(problem, fit);
  for (const std::size_t part : {kForward, kTurnRate, kBackward, kSideward, kForward}) {
    WalkState best = fit.state;
    double least = walk_cost_of(problem, fit, best, every);
    for (const double factor : {0.35, 0.5, 0.7, 0.85, 1.2, 1.6}) {
      WalkState other = fit.state;
      other.parameters[part] = in_bounds(part, other.parameters[part] + std::log(factor));
      const double cost = walk_cost_of(problem, fit, other, every);
      if (cost < least * (1 - 1e-9)) least = cost, best = other;
    }
    fit.state = best;
  }
}

}  // namespace

double WalkState::value(WalkPart part) const {
  return is_logarithm(part) ? std::exp(parameters[part]) : parameters[part];
}

Walk WalkState::walk_of(std::size_t robot, const Walk& base) const {
  Walk walk = base;
  for (std::size_t i = 0; i < kWalkParts; ++i)
    walk_member_of(walk, static_cast<WalkPart>(i)) = static_cast<float>(value(static_cast<WalkPart>(i)));
  const auto pace = static_cast<float>(std::exp(log_pace(robot)));
  walk.forward *= pace, walk.backward *= pace, walk.sideward *= pace;
  return walk;
}

double WalkFit::deviation(std::size_t parameter) const {
  return std::sqrt(std::max(0., covariance[parameter][parameter]));
}

double WalkFit::deviation_of_sum(const Vector& combination) const {
  double variance = 0;
  for (std::size_t i = 0; i < combination.size(); ++i)
    for (std::size_t j = 0; j < combination.size(); ++j)
      if (combination[i] != 0 && combination[j] != 0) variance += combination[i] * combination[j] * covariance[i][j];
  return std::sqrt(std::max(0., variance));
}

WalkProblem walk_problem_of(const Drives& drives) {
  WalkProblem problem{.tracks = {},
                      .clock_deviation = drives.clock_deviation,
                      .clocks = drives.clocks,
                      .place_deviation = drives.place_deviation,
                      .heading_deviation = drives.heading_deviation};
  for (const Drive& drive : drives.drives)
    if (DriveTrack track(drive); track.blocks() >= 2) problem.tracks.push_back(std::move(track));
  return problem;
}

double enough_of(WalkPart part) {
  switch (part) {
    case kAcceleration:
    case kTurnAcceleration: return 8;
    case kStartDelay: return 6;
    default: return 10;
  }
}

WalkFit fit_walk(const WalkProblem& problem, const Walk& base) {
  const std::size_t robots = problem.clock_deviation.size();
  WalkFit fit{.state = walk_state_of(base, problem.clocks), .base = base};
  fit.free.assign(kWalkParts + 2 * robots, true);
  for (std::size_t i = 0; i < robots; ++i) {
    fit.free[kWalkParts + i] = problem.robots_differ && robots > 1;
    fit.free[kWalkParts + robots + i] = problem.clock_deviation[i] > 0 && problem.clocks[i] == i;
  }
  search_start(problem, fit);
  do {
    weigh_drives(problem, fit);
    descend_walk(problem, true, fit);
    count_shown(fit);
  } while (fix_hidden(base, fit));
  measure_walk(problem, fit);
  return fit;
}

WalkFit refit_walk(const WalkProblem& problem, const WalkFit& before, double speed_noise, double turn_noise) {
  WalkFit fit = before;
  fit.base.speed_noise = static_cast<float>(speed_noise);
  fit.base.turn_noise = static_cast<float>(turn_noise);
  weigh_drives(problem, fit);
  descend_walk(problem, false, fit);
  count_shown(fit);
  measure_walk(problem, fit);
  return fit;
}

void add_luck(const WalkProblem& problem, double speed_noise_deviation, double turn_noise_deviation, WalkFit& fit) {
  const WalkSum here = walk_sum_of(problem, fit);
  const std::pair<float Walk::*, double> lucks[] = {{&Walk::speed_noise, speed_noise_deviation},
                                                    {&Walk::turn_noise, turn_noise_deviation}};
  for (const auto& [member, deviation] : lucks) {
    if (!(deviation > 0)) continue;
    WalkFit other = fit;
    other.base.*member += static_cast<float>(deviation);
    // with the weights of the fit, so that only the mean gait differs
    form_equations(problem, false, other);
    WalkSum moved = walk_sum_of(problem, other);
    const auto step = walk_step_by(moved, 0), before = walk_step_by(here, 0);
    if (!step || !before) continue;
    const std::size_t all = fit.free.size();
    for (std::size_t i = 0; i < all; ++i)
      for (std::size_t j = 0; j < all; ++j)
        if (fit.free[i] && fit.free[j]) {
          const std::size_t a = here.place[i], b = here.place[j];
          fit.covariance[i][j] += ((*step)[a] - (*before)[a]) * ((*step)[b] - (*before)[b]);
        }
  }
}

WalkState state_without(const WalkFit& fit, const WalkProblem& problem, const std::vector<bool>& left_out) {
  const WalkSum sum = walk_sum_of(problem, fit, &left_out);
  const auto step = walk_step_by(sum, 0);
  return step ? walk_stepped(fit, sum, *step) : fit.state;
}

}  // namespace robot::fit
