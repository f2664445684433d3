// The check of one parameter that a team's process announces.
#pragma once

#include <string>

#include "proto/foresight/live_parameters.pb.h"
#include "robot/core/result.h"
#include "robot/net/foxglove/parameters.h"

namespace robot::app {

inline constexpr std::size_t kMaxProcessBytes = 32, kMaxNameBytes = 48, kMaxUnitBytes = 16, kMaxTextBytes = 200;
inline constexpr int kMaxChoices = 32;

/// Returns whether `name` can be that of a process: letters, digits, '_' and '-'.
bool is_process_name(std::string_view name);

/// Returns the entry "PROCESS.NAME" for the table of parameters. Returns an Error that names the parameter and the part
/// that does not fit.
Result<net::OfferedParameter> offered_parameter(const foresight::LiveParameter& announced, const std::string& process);

/// Sets the present value of `parameter`, whose type is that of `value`.
void put_value(foresight::LiveParameter& parameter, const net::ParameterValue& value);

}  // namespace robot::app
