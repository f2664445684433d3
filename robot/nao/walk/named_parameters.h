// The names of all numbers of the walk: for parameter files, searches and benches.
#pragma once

#include <iterator>
#include <string_view>

#include "robot/nao/walk/parameters.h"

namespace robot::nao::walk {

struct NamedParameter {
  std::string_view name;
  double Parameters::*place;
  std::string_view unit;
  std::string_view meaning;  // the words of parameters.h, for people
};

/// Values from `low` to `high`, both included.
struct ParameterRange {
  double low, high;
};

inline constexpr NamedParameter kNamedParameters[] = {
    {"period", &Parameters::period, "s", "planned duration of a step; B-Human have 0.25 s, HULKs 0.235 s"},
    {"hip_height", &Parameters::hip_height, "m", "height of the hip above the soles"},
    {"ahead", &Parameters::ahead, "m", "the hip stands this far in front of the middle of the ankles"},
    {"wider", &Parameters::wider, "m", "each foot stands this far outside of its place under the hip"},
    {"lift", &Parameters::lift, "m", "height of the swing foot"},
    {"lift_per_stride", &Parameters::lift_per_stride, "m/m", "more for a longer step, forwards or backwards"},
    {"lift_per_side", &Parameters::lift_per_side, "m/m", "more for a step to the side"},
    {"lift_per_turn", &Parameters::lift_per_turn, "m/rad", "more for a turning step"},
    {"lift_per_catch", &Parameters::lift_per_catch, "m/m", "more for a step that catches a fall"},
    {"landing", &Parameters::landing, "period", "the swing foot moves with the ground from then on"},
    {"share", &Parameters::share, "0..1", "share of the weight on the swing foot that ends the step"},
    {"earliest", &Parameters::earliest, "period", "the exchange of the support foot comes no earlier"},
    {"latest", &Parameters::latest, "period", "then that exchange is forced"},
    {"hanging", &Parameters::hanging, "period", "so much later while the robot hangs on an outer edge"},
    {"hanging_share", &Parameters::hanging_share, "0..1", "it hangs while the swing foot carries less"},
    {"lookahead", &Parameters::lookahead, "ticks", "the weight on the swing foot is predicted for this time"},
    {"smoothing", &Parameters::smoothing, "0..1", "share of the old value in the low pass of the gyroscope"},
    {"rate_to_ankle_pitch", &Parameters::rate_to_ankle_pitch, "rad s/rad",
     "feedback of the gyroscope to the support leg"},
    {"rate_to_ankle_roll", &Parameters::rate_to_ankle_roll, "rad s/rad",
     "feedback of the gyroscope to the support leg"},
    {"rate_to_hip_pitch", &Parameters::rate_to_hip_pitch, "rad s/rad", "feedback of the gyroscope to the support leg"},
    {"tilt_to_ankle_pitch", &Parameters::tilt_to_ankle_pitch, "rad/rad",
     "feedback of the torso's angle to the support leg"},
    {"tilt_to_ankle_roll", &Parameters::tilt_to_ankle_roll, "rad/rad",
     "feedback of the torso's angle to the support leg"},
    {"com_height", &Parameters::com_height, "m", "height of the centre of mass, for the pendulum"},
    {"catch_forward", &Parameters::catch_forward, "m/m", "shift of the swing foot per error of the capture point"},
    {"catch_forward_from", &Parameters::catch_forward_from, "m", "smaller errors have no effect"},
    {"catch_forward_most", &Parameters::catch_forward_most, "m", "bound of that shift"},
    {"catch_side", &Parameters::catch_side, "m/m", "shift of the swing foot to the side"},
    {"catch_side_from", &Parameters::catch_side_from, "m", "smaller errors have no effect"},
    {"catch_side_most", &Parameters::catch_side_most, "m", "bound of that shift"},
    {"counter", &Parameters::counter, "m/m", "outward shift when the robot tips over the support foot"},
    {"counter_from", &Parameters::counter_from, "m", "smaller errors have no effect"},
    {"counter_most", &Parameters::counter_most, "m", "bound of that shift"},
    {"catch_speed", &Parameters::catch_speed, "m/s", "fastest shift of the swing foot"},
    {"side_speed", &Parameters::side_speed, "m/s", "fastest shift of the swing foot to the side"},
    {"learning", &Parameters::learning, "0..1", "share of a new measurement in the usual course of the error"},
    {"usual_forward_most", &Parameters::usual_forward_most, "m", "bound of that course"},
    {"usual_side_most", &Parameters::usual_side_most, "m", "bound of that course to the side"},
    {"fights_from", &Parameters::fights_from, "m", "a larger shift counts as a fight for balance"},
    {"calm_share", &Parameters::calm_share, "0..1", "share of the commanded speed in a fight"},
    {"calm_rise", &Parameters::calm_rise, "0..1", "share of the commanded speed, regained in each step"},
    {"lean_learning", &Parameters::lean_learning, "0..1", "share of the mean error that moves the hip, in each step"},
    {"lean_most", &Parameters::lean_most, "m", "bound of that move"},
    {"forward_change", &Parameters::forward_change, "m/s", "largest change in a step; twice as much for slowing down"},
    {"side_change", &Parameters::side_change, "m/s", "largest change in a step"},
    {"turn_change", &Parameters::turn_change, "rad/s", "largest change in a step"},
    {"longer", &Parameters::longer, "0..1",
     "share by which strides are planned longer: legs fall short of their targets"},
    {"speed_learning", &Parameters::speed_learning, "0..1",
     "share of the error of the speed that corrects the plan, in each step"},
    {"correction_most", &Parameters::correction_most, "m/s", "bound of that correction"},
    {"heading_rate", &Parameters::heading_rate, "1/s", "return to the wanted heading"},
    {"heading_most", &Parameters::heading_most, "rad/s", "bound of that turn"},
    {"kick_speed", &Parameters::kick_speed, "m/s",
     "the robot walks into the ball: a kick on the spot is weaker and shorter"},
    {"kick_reach", &Parameters::kick_reach, "m", "distance of the farthest ball from the torso, when the step begins"},
    {"kick_period", &Parameters::kick_period, "s", "duration of the step that kicks"},
    {"kick_lift", &Parameters::kick_lift, "m", "the foot is lifted higher"},
    {"kick_ahead", &Parameters::kick_ahead, "m", "the foot swings ahead, beyond its place"},
    {"kick_side", &Parameters::kick_side, "m", "the foot swings outwards, beyond its place"},
    {"kick_turn", &Parameters::kick_turn, "rad", "the foot turns inwards"},
    {"kick_from", &Parameters::kick_from, "kick_period", "the swing begins"},
    {"kick_contact", &Parameters::kick_contact, "kick_period", "the foot is ahead"},
    {"kick_over", &Parameters::kick_over, "kick_period", "the foot would be at its place"},
    {"lag_share", &Parameters::lag_share, "0..1", "share of the servos' lag that is led"},
    {"lag_most", &Parameters::lag_most, "s", "bound of the lag"},
    {"lead_most", &Parameters::lead_most, "rad", "bound of the lead"},
    {"sag_learning", &Parameters::sag_learning, "0..1",
     "share of the error of a carrying leg in its sag, in each tick"},
    {"sag_most", &Parameters::sag_most, "rad", "bound of the sag"},
    {"sag_rise", &Parameters::sag_rise, "period", "the new support leg is raised until then, the other is let down"},
    {"stand_forward", &Parameters::stand_forward, "m", "error forwards or backwards that starts steps"},
    {"stand_side", &Parameters::stand_side, "m", "error to a side that starts steps"},
};

/// Returns where the parameter of that name is, or null.
constexpr double Parameters::*parameter_named(std::string_view name) {
  for (const NamedParameter& known : kNamedParameters)
    if (known.name == name) return known.place;
  return nullptr;
}

/// Returns the values that a person may choose: a quarter of the default to four times that. Others are mistakes.
constexpr ParameterRange range_of(double Parameters::*place) {
  const double usual = Parameters{}.*place;
  return {usual / 4, usual * 4};
}

static_assert(sizeof(Parameters) == std::size(kNamedParameters) * sizeof(double), "each parameter has a name");

}  // namespace robot::nao::walk
