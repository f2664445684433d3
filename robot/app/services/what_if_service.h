// The services of foresight: people and programs ask for the best strategy from the current moment on.
#pragma once

#include <cstdint>
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "proto/foresight/forecast.pb.h"
#include "robot/core/result.h"
#include "robot/net/foxglove/services.h"

namespace robot::app {

/// Answers a question from the current knowledge of the robot of that name ("14/2"). Of a recording, from its knowledge at
/// the time of the asker's own playhead [ns], if it has one. Blocks until the answer is there.
using AskForesight = std::function<Result<foresight::Forecast>(const std::string& robot, const foresight::WhatIf&,
                                                               std::optional<std::uint64_t> playhead_ns)>;

/// Adds /foresight/what_if and /foresight/strategies. A request of the first is a question
/// (robot/foresight/question.h). Its entry "robot" is needed only for another robot than `robot`:
///
///   {"robot": "14/2", "strategies": ["baseline", "passing"], "horizon": 30, "budget_ms": 500, …}
///
/// The answer is {"ok": true, "robot", "forecast": {…}}. If the question is wrong or the robot knows too little, it is
/// {"ok": false, "error": sentence}. "answered_ms" counts from the arrival of the question. From another machine the
/// service needs the token. It also answers during a game.
///
/// The second takes {} and answers {"ok": true, "strategies": ["baseline", "passing", …]}: `strategies`, the names that
/// a question may use, in this order. Every client may call it, also in match mode.
void add_what_if_service(net::Services& services, const std::string& robot, std::vector<std::string> strategies,
                         AskForesight ask);

}  // namespace robot::app
