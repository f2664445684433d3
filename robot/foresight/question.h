// Questions and answers of foresight: as JSON for people and services, checked before anything is done.
#pragma once

#include <nlohmann/json.hpp>
#include <string>
#include <string_view>
#include <vector>

#include "proto/foresight/forecast.pb.h"
#include "robot/core/result.h"
#include "sim/foresight/question.h"

namespace robot::foreseeing {

namespace pb = ::foresight;

/// How `asked_by` begins where it was no process of the team's own.
inline constexpr std::string_view kByPeople = "people", kByCaptain = "captain: ";

/// {"strategies": ["baseline", "passing"], "opponent": "baseline", "measure": "goal_difference" | "score_next" | "concede",
///  "until": "horizon" | "next_goal" | "half" | "game", "horizon": 30, "budget_ms": 500, "switching_cost": 0.02,
///  "edit": {"ball": {"x", "y"}, "robots": [{"side": "own" | "opponent", "player", "x", "y", "heading"}],
///           "own_score", "opponent_score", "seconds_remaining"}}
/// Everything may be left out; metres and radians of team_field, seconds. What is none of these is refused.
Result<pb::WhatIf> parse_question(const nlohmann::json& json);

/// The fields of the message by their names; enumerators in small letters: "keep". Paths and heat only `in_full`.
nlohmann::json to_json(const pb::Forecast& forecast, bool in_full);

/// Fills what was left out and checks the rest: strategies are among those `known`, numbers in the ranges that the .proto
/// states.
Result<pb::WhatIf> complete(pb::WhatIf question, const std::vector<std::string>& known);

sim::foresight::Question question_of(const pb::WhatIf& question);

}  // namespace robot::foreseeing
