// The names of all numbers of the walk: for parameter files, searches and benches.
#pragma once

#include <iterator>
#include <string_view>

#include "robot/nao/walk/parameters.h"

namespace robot::nao::walk {

struct NamedParameter {
  std::string_view name;
  double Parameters::*place;
};

inline constexpr NamedParameter kNamedParameters[] = {
    {"period", &Parameters::period},
    {"hip_height", &Parameters::hip_height},
    {"ahead", &Parameters::ahead},
    {"wider", &Parameters::wider},
    {"lift", &Parameters::lift},
    {"lift_per_stride", &Parameters::lift_per_stride},
    {"lift_per_side", &Parameters::lift_per_side},
    {"lift_per_turn", &Parameters::lift_per_turn},
    {"lift_per_catch", &Parameters::lift_per_catch},
    {"landing", &Parameters::landing},
    {"share", &Parameters::share},
    {"earliest", &Parameters::earliest},
    {"latest", &Parameters::latest},
    {"hanging", &Parameters::hanging},
    {"hanging_share", &Parameters::hanging_share},
    {"lookahead", &Parameters::lookahead},
    {"smoothing", &Parameters::smoothing},
    {"rate_to_ankle_pitch", &Parameters::rate_to_ankle_pitch},
    {"rate_to_ankle_roll", &Parameters::rate_to_ankle_roll},
    {"rate_to_hip_pitch", &Parameters::rate_to_hip_pitch},
    {"tilt_to_ankle_pitch", &Parameters::tilt_to_ankle_pitch},
    {"tilt_to_ankle_roll", &Parameters::tilt_to_ankle_roll},
    {"com_height", &Parameters::com_height},
    {"catch_forward", &Parameters::catch_forward},
    {"catch_forward_from", &Parameters::catch_forward_from},
    {"catch_forward_most", &Parameters::catch_forward_most},
    {"catch_side", &Parameters::catch_side},
    {"catch_side_from", &Parameters::catch_side_from},
    {"catch_side_most", &Parameters::catch_side_most},
    {"counter", &Parameters::counter},
    {"counter_from", &Parameters::counter_from},
    {"counter_most", &Parameters::counter_most},
    {"catch_speed", &Parameters::catch_speed},
    {"side_speed", &Parameters::side_speed},
    {"learning", &Parameters::learning},
    {"usual_forward_most", &Parameters::usual_forward_most},
    {"usual_side_most", &Parameters::usual_side_most},
    {"fights_from", &Parameters::fights_from},
    {"calm_share", &Parameters::calm_share},
    {"calm_rise", &Parameters::calm_rise},
    {"lean_learning", &Parameters::lean_learning},
    {"lean_most", &Parameters::lean_most},
    {"forward_change", &Parameters::forward_change},
    {"side_change", &Parameters::side_change},
    {"turn_change", &Parameters::turn_change},
    {"longer", &Parameters::longer},
    {"speed_learning", &Parameters::speed_learning},
    {"correction_most", &Parameters::correction_most},
    {"heading_rate", &Parameters::heading_rate},
    {"heading_most", &Parameters::heading_most},
    {"kick_speed", &Parameters::kick_speed},
    {"kick_reach", &Parameters::kick_reach},
    {"kick_period", &Parameters::kick_period},
    {"kick_lift", &Parameters::kick_lift},
    {"kick_ahead", &Parameters::kick_ahead},
    {"kick_side", &Parameters::kick_side},
    {"kick_turn", &Parameters::kick_turn},
    {"kick_from", &Parameters::kick_from},
    {"kick_contact", &Parameters::kick_contact},
    {"kick_over", &Parameters::kick_over},
    {"lag_share", &Parameters::lag_share},
    {"lag_most", &Parameters::lag_most},
    {"lead_most", &Parameters::lead_most},
    {"sag_learning", &Parameters::sag_learning},
    {"sag_most", &Parameters::sag_most},
    {"sag_rise", &Parameters::sag_rise},
    {"stand_forward", &Parameters::stand_forward},
    {"stand_side", &Parameters::stand_side},
};
/// Returns where the parameter of that name is, or null.
constexpr double Parameters::*parameter_named(std::string_view name) {
  for (const NamedParameter& known : kNamedParameters)
    if (known.name == name) return known.place;
  return nullptr;
}

static_assert(sizeof(Parameters) == std::size(kNamedParameters) * sizeof(double), "each parameter has a name");

}  // namespace robot::nao::walk
