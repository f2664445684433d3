// Scores of the forecasts in a recording: how well they came true.
#pragma once

#include <map>
#include <string>

#include "proto/foresight/forecast.pb.h"
#include "robot/logging/sessions/session.h"

namespace robot::app {

/// Returns the scores by robot ("14/2"), for each robot that recorded forecasts and the game. Skips unreadable
/// data.
std::map<std::string, foresight::ForecastScore> score_forecasts(const logging::Session& session);

}  // namespace robot::app
