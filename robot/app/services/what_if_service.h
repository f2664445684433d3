// The services of foresight: people and programs ask which strategy is best from here on.
#pragma once

#include <cstdint>
#include <functional>
#include <string>
#include <vector>

#include "proto/foresight/forecast.pb.h"
#include "robot/core/result.h"
#include "robot/net/foxglove/services.h"

namespace robot::app {

/// Who answers: asks from what the robot of that name ("14/2") knows now, and waits.
using AskForesight = std::function<Result<foresight::Forecast>(const std::string& robot, const foresight::WhatIf&)>;

/// Adds /foresight/what_if and /foresight/strategies. The request of the first is a question as robot/foresight/question.h has it, and "robot" where it is not `robot`:
///
///   {"robot": "14/2", "strategies": ["baseline", "passing"], "horizon": 30, "budget_ms": 500, …}
///
/// The answer is {"ok": true, "robot", "forecast": {…}}, or {"ok": false, "error": sentence} where the question makes no
/// sense or nothing can be told: "cannot tell, because nobody has seen the ball yet". Its "answered_ms" counts from when the
/// question came. It needs the token from beyond this machine, and in match mode there is none: "game in progress".
///
/// The second takes {} and answers {"ok": true, "strategies": ["baseline", "passing", …]}: `strategies`, the names that a
/// question may use, in this order. Every client may call it, in match mode too.
void add_what_if_service(net::Services& services, const std::string& robot, std::vector<std::string> strategies,
                         AskForesight ask);

}  // namespace robot::app
