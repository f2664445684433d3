// How well the forecasts in a recording came true.
#pragma once

#include <map>
#include <string>

#include "proto/foresight/forecast.pb.h"
#include "robot/logging/sessions/session.h"

namespace robot::app {

/// By robot ("14/2"), of each that recorded forecasts and the game. What cannot be read is left out.
std::map<std::string, foresight::ForecastScore> score_forecasts(const logging::Session& session);

}  // namespace robot::app
