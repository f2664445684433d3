#include "robot/nao/walk/walk.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "robot/nao/walk/named_parameters.h"

namespace robot::nao::walk {
namespace {

constexpr double kChange = 0.5;          // [s] from one set of parameters to another
constexpr double kLongestPhase = 1.4;    // [period] the feet move on until then
constexpr double kLeastWeight = 1;       // [kg] both feet together, if the robot stands on the ground
constexpr double kLifted = 0.3;          // [s] without weight: somebody has lifted it
constexpr double kDown = 0.3;            // [0..1] share of a swing foot that has landed
constexpr double kClosing = 0.05;        // [m/s], [rad/s] speed of the feet of a standing robot to their places
constexpr double kFirstLift = 0.5;       // of the lift in the first step
constexpr double kLastLift = 0.4;        // of the lift in steps on the spot before it stands: they rock less
constexpr double kLiftPower = 1.3;       // of the sine: the foot leaves the ground softly
constexpr int kWarmUp = 2;               // [steps] at the beginning teach nothing
constexpr double kMeanErrorMost = 0.04;  // [m] a larger error does not count more in the mean
constexpr double kShortestStep = 0.1;    // [s]
constexpr double kOdometryShare = 0.2;   // of a step in the speed that the legs report
constexpr double kStopSpeed = 0.03;      // [m/s] it may stop below
constexpr double kStopForward = 0.045, kStopSide = 0.085;  // [m] errors that two feet on the ground hold
constexpr double kTipsAside = 0.02;                        // [m] error that selects the first foot
constexpr double kSettling = 0.8;                          // [s] after a stop, it rocks to rest
constexpr double kSettlingMargin = 2.4;                    // of the errors that start steps, meanwhile

/// Moves `value` towards `goal` by at most `change`, and twice as fast towards zero.
void approach(double goal, double change, double& value) {
  const double most = std::abs(goal) < std::abs(value) ? 2 * change : change;
  value += std::clamp(goal - value, -most, most);
}

/// Returns a smooth step from 0 to 1.
double smooth(double part) { return 0.5 - 0.5 * std::cos(std::numbers::pi * std::clamp(part, 0.0, 1.0)); }

/// Returns the part of `error` beyond `from`, times `gain`, at most `most`.
double beyond(double error, double from, double gain, double most) {
  const double rest = std::abs(error) - from;
  return rest > 0 ? std::copysign(std::min(gain * rest, most), error) : 0;
}

}  // namespace

Legs stand(const Parameters& parameters) {
  const Sole sole{{-parameters.ahead, 0, -parameters.hip_height}, 0};
  return reach({sole, sole}, 0, 0);
}

Walk::Walk(const Parameters& parameters)
    : parameters_(parameters), balance_(parameters_), lag_(parameters_), sag_(parameters_), wanted_(parameters) {}

void Walk::change(const Parameters& parameters) {
  wanted_ = parameters;
  change_ = kChange;
}

void Walk::approach_wanted(double dt) {
  if (change_ <= 0) return;
  const double share = std::min(dt / change_, 1.0);
  for (const NamedParameter& named : kNamedParameters) {
    double& number = parameters_.*named.place;
    number += share * (wanted_.*named.place - number);
  }
  change_ -= dt;
  if (change_ <= 0) parameters_ = wanted_;
}

const Legs& Walk::tick(const Sensors& sensors, const Command& command, double dt) {
  approach_wanted(dt);
  feel(sensors, dt);
  return_ = heading_turn(command, sensors, dt);
  const bool stood = !stepping_, lifted = lifted_ > kLifted;
  if (lifted) stepping_ = false;
  if (stood && !lifted) start_if_needed(sensors, command);
  if (stepping_) {
    if (!stood) time_ += dt;
    end_step(sensors, command);
  }
  if (stepping_) {
    const Tipping error = balance_.disturbance(swing_, phase());
    if (count_ > kWarmUp) balance_.learn(swing_, phase());
    catch_fall(error, dt);
    move_feet();
  } else {
    close_feet(dt);
  }
  pose(sensors, dt);
  return targets_;
}

void Walk::feel(const Sensors& sensors, double dt) {
  balance_.see(sensors);
  const double sum = sensors.load_of(left) + sensors.load_of(right);
  on_ground_ = sum > kLeastWeight;
  lifted_ = on_ground_ ? 0 : lifted_ + dt;
  last_share_ = share_;
  share_ = on_ground_ ? sensors.load_of(swing_) / sum : 0;
  error_sum_ += std::clamp(balance_.error().forward, -kMeanErrorMost, kMeanErrorMost);
  ++errors_;
}

/// Returns the turn that corrects the heading. Small errors of the joints make each robot turn by itself.
double Walk::heading_turn(const Command& command, const Sensors& sensors, double dt) {
  if (!stepping_) {
    heading_error_ = 0;
    return 0;
  }
  const double most = parameters_.heading_most / std::max(parameters_.heading_rate, 1e-9);
  heading_error_ = std::clamp(heading_error_ + (command.turn * calm_ - sensors.rate[2]) * dt, -most, most);
  return parameters_.heading_rate * heading_error_;
}

void Walk::start_if_needed(const Sensors& sensors, const Command& command) {
  const Tipping& error = balance_.error();
  const double margin = still_ < kSettling ? kSettlingMargin : 1;
  const bool tips = std::abs(error.forward) > margin * parameters_.stand_forward ||
                    std::abs(error.left) > margin * parameters_.stand_side;
  if (command.stands() && !tips) return;
  stepping_ = true;
  count_ = 0;
  speed_ = {};
  swing_ = share_ < 0.5 ? swing_ : other(swing_);
  // a robot that tips to one side steps with that foot
  if (std::abs(error.left) > kTipsAside) swing_ = error.left > 0 ? left : right;
  share_ = last_share_ = sensors.load_of(swing_) / std::max(sensors.load_of(left) + sensors.load_of(right), 1e-9);
  begin_step(sensors, command);
}

/// Exchanges the feet when the swing foot carries weight, or when that takes too long.
void Walk::end_step(const Sensors& sensors, const Command& command) {
  const Parameters& p = parameters_;
  const double expected = share_ + p.lookahead * (share_ - last_share_);
  const bool landed = phase() > p.earliest && expected > p.share;
  const bool hangs = share_ < p.hanging_share && phase() < p.latest + p.hanging;
  const bool late = phase() > p.latest && !hangs;
  if (!landed && !late) return;

  duration_ = time_;
  ++count_;
  swing_ = other(swing_);
  share_ = 1 - share_;
  time_ = 0;
  if (may_stand(command)) {
    stepping_ = false;
    still_ = 0;
    return;
  }
  judge_last_step(sensors);
  govern();
  begin_step(sensors, command);
}

bool Walk::may_stand(const Command& command) const {
  const Tipping& error = balance_.error();
  return command.stands() && count_ > kWarmUp + 1 && std::abs(speed_.forward) < kStopSpeed &&
         std::abs(speed_.left) < kStopSpeed && std::abs(error.forward) < kStopForward &&
         std::abs(error.left) < kStopSide;
}

/// Compares the step that ended with its plan: the legs report the stride, the balance its mean error.
void Walk::judge_last_step(const Sensors& sensors) {
  const Parameters& p = parameters_;
  const double mean_error = error_sum_ / std::max(1, errors_);
  if (count_ > 1) {
    // the new swing foot supported until now
    const Point end = sole_of(sensors.joints[swing_], swing_);
    const double time = std::max(kShortestStep, duration_);
    real_speed_.forward += kOdometryShare * ((support_start_.x - end.x) / time - real_speed_.forward);
    real_speed_.left += kOdometryShare * ((support_start_.y - end.y) / time - real_speed_.left);
    const auto correct = [&](double planned, double real, double& correction) {
      correction = std::clamp(correction + p.speed_learning * (planned - real), -p.correction_most, p.correction_most);
    };
    if (calm_ > 0.95 && std::abs(worst_shift_.forward) < 0.04) {
      correct((1 + p.longer) * speed_.forward, real_speed_.forward, correction_.forward);
      correct(speed_.left, real_speed_.left, correction_.left);
    }
    lean_ = std::clamp(lean_ - p.lean_learning * mean_error, -p.lean_most, p.lean_most);
  }
  error_sum_ = 0, errors_ = 0;
}

/// Slows the robot down while it fights for balance.
void Walk::govern() {
  const Parameters& p = parameters_;
  const double shift = std::abs(worst_shift_.forward);
  calm_ = shift > p.fights_from ? p.calm_share : std::min(1.0, calm_ + p.calm_rise);
}

void Walk::begin_step(const Sensors& sensors, const Command& command) {
  const Parameters& p = parameters_;
  approach(command.forward * calm_, p.forward_change, speed_.forward);
  approach(command.left * calm_, p.side_change, speed_.left);
  approach(command.turn * calm_ + return_, p.turn_change, speed_.turn);
  kick_ = command.foot == swing_ && count_ > kWarmUp ? command.kick : KickStep::none;
  ends_ = command.stands() && std::abs(speed_.forward) < kStopSpeed && std::abs(speed_.left) < kStopSpeed;
  stride_ = ((1 + p.longer) * speed_.forward + correction_.forward) * p.period;
  const double side = (speed_.left + correction_.left) * p.period, turn = speed_.turn * p.period;
  support_start_ = sole_of(sensors.joints[other(swing_)], other(swing_));

  // a step to its own side opens the legs, the next one closes them
  const double out = sign_of(swing_);
  const double opens = side * out > 0 ? side : 0, turns = turn * out > 0 ? turn : 0;
  end_[swing_] = {.y = opens + out * p.wider, .yaw = turns};
  end_[other(swing_)] = {.y = -opens - out * p.wider, .yaw = -turns};
  start_ = feet_;
  shift_ = worst_shift_ = {};
}

/// Moves the place of the swing foot to where the robot tips, and back when it does not.
void Walk::catch_fall(const Tipping& error, double dt) {
  const Parameters& p = parameters_;
  Tipping wanted;
  if (on_ground_) {
    wanted.forward = beyond(error.forward, p.catch_forward_from, p.catch_forward, p.catch_forward_most);
    // only outwards: the feet must not meet. A leg stretched to the other side is a counterweight.
    const double out = sign_of(swing_);
    wanted.left = error.left * out > 0 ? beyond(error.left, p.catch_side_from, p.catch_side, p.catch_side_most)
                                       : -beyond(error.left, p.counter_from, p.counter, p.counter_most);
  }
  const bool down = share_ > kDown && phase() > 0.5;
  if (!down) {
    const double most = p.catch_speed * dt, most_left = p.side_speed * dt;
    shift_.forward += std::clamp(wanted.forward - shift_.forward, -most, most);
    shift_.left += std::clamp(wanted.left - shift_.left, -most_left, most_left);
  }
  if (std::abs(shift_.forward) > std::abs(worst_shift_.forward)) worst_shift_ = shift_;
}

/// Returns the swing of a kick from 0 to 1. It begins at full speed.
double Walk::kick_swing() const {
  const Parameters& p = parameters_;
  const double now = phase();
  if (now < p.kick_from) return 0;
  if (now < p.kick_contact)
    return std::sin(std::numbers::pi / 2 * (now - p.kick_from) / (p.kick_contact - p.kick_from));
  return 1 - smooth((now - p.kick_contact) / (p.kick_over - p.kick_contact));
}

double Walk::lift() const {
  const Parameters& p = parameters_;
  const double height =
      p.lift + p.lift_per_stride * std::abs(stride_) + p.lift_per_side * std::abs(speed_.left * p.period) +
      p.lift_per_turn * std::abs(speed_.turn * p.period) + p.lift_per_catch * std::abs(shift_.forward);
  if (kick_ != KickStep::none) return height + p.kick_lift;
  return count_ == 0 ? kFirstLift * height : ends_ ? kLastLift * height : height;
}

void Walk::move_feet() {
  const double now = phase(), along = std::min(now, kLongestPhase), part = std::min(now, 1.0);
  const auto between = [](double from, double to, double share) { return from + share * (to - from); };

  // the support foot goes back with the ground
  const Side support = other(swing_);
  Foot& on = feet_[support];
  on.x = between(start_[support].x, -stride_ / 2, along);
  on.y = between(start_[support].y, end_[support].y, part);
  on.yaw = between(start_[support].yaw, end_[support].yaw, part);
  on.z = 0;

  // the swing foot goes to its place, then back with the ground
  const double landing = parameters_.landing, arrives = smooth(now / landing);
  const double back = std::max(0.0, along - landing) * stride_;
  const double shifted = std::min(1.0, 2 * now);
  Foot& free = feet_[swing_];
  free.x = between(start_[swing_].x, stride_ / 2 + (1 - landing) * stride_, arrives) - back + shifted * shift_.forward;
  free.y = between(start_[swing_].y, end_[swing_].y, arrives) + shifted * shift_.left;
  free.yaw = between(start_[swing_].yaw, end_[swing_].yaw, arrives);
  if (kick_ != KickStep::none) {
    const double swing = kick_swing(), out = sign_of(swing_);
    if (kick_ == KickStep::forward) free.x += swing * parameters_.kick_ahead;
    if (kick_ == KickStep::side) free.y += out * swing * parameters_.kick_side;
    if (kick_ == KickStep::turn) free.yaw -= out * swing * parameters_.kick_turn;
  }
  free.z = now < 1 ? lift() * std::pow(std::sin(std::numbers::pi * now), kLiftPower) : 0;
}

void Walk::close_feet(double dt) {
  still_ += dt;
  const double step = kClosing * dt;
  for (Foot& foot : feet_) {
    foot.z = 0;
    for (double* value : {&foot.x, &foot.y, &foot.yaw}) *value -= std::clamp(*value, -step, step);
  }
}

/// Returns the shares of the weight that the legs carry by plan.
HipSag::Weights Walk::carried() const {
  HipSag::Weights weights{0.5, 0.5};
  if (!stepping_) return weights;
  const double from = count_ == 0 ? 0.5 : 0, share = smooth(phase() / parameters_.sag_rise);
  weights[other(swing_)] = from + (1 - from) * share;
  weights[swing_] = 1 - weights[other(swing_)];
  return weights;
}

/// Turns the places of the feet into angles of the joints.
void Walk::pose(const Sensors& sensors, double dt) {
  const Parameters& p = parameters_;
  std::array<Sole, 2> soles;
  for (const Side side : {left, right}) {
    const Foot& foot = feet_[side];
    soles[side] = {{foot.x - p.ahead - lean_, foot.y, foot.z - p.hip_height}, foot.yaw};
  }
  const Legs plan = reach(soles, 0, hip_yaw_pitch_);
  hip_yaw_pitch_ = plan[left][hip_yaw_pitch];

  if (stepping_) lag_.see(sensors.joints, plan, swing_, dt);
  const HipSag::Weights weights = carried();
  if (stepping_) sag_.see(sensors.joints, weights);
  targets_ = stepping_ ? lag_.led(plan, dt) : lag_.unled(plan);
  std::array<double, 2> supports{0.5, 0.5};
  if (stepping_) supports[swing_] = 0, supports[other(swing_)] = 1;
  balance_.steady(supports, targets_);
  sag_.raise(plan, weights, targets_);
}

}  // namespace robot::nao::walk
