// Questions and answers of foresight: as JSON for people and services, checked before anything is done.
#pragma once

#include <cstdint>
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

/// What the others are taken to play where the question does not say.
inline constexpr const char* kDefaultOpponent = "baseline";

/// {"strategies": ["baseline", "passing"], "opponent": "baseline", "measure": "goal_difference" | "score_next" | "concede",
///  "until": "horizon" | "next_goal" | "half" | "game", "horizon": 30, "budget_ms": 500, "switching_cost": 0.02, "sure": 0.9,
///  "edit": {"ball": {"x", "y"}, "robots": [{"side": "own" | "opponent", "player", "x", "y", "heading"}],
///           "own_score", "opponent_score", "seconds_remaining"}}
/// Everything may be left out; metres and radians of team_field, seconds. What is none of these is refused, and so is a
/// 0 that would be left out in a message.
Result<pb::WhatIf> parse_question(const nlohmann::json& json);

/// The fields of the message by their names, but for the situation: {"ball": {"x", "y", "deviation", "elsewhere"},
/// "robots": [{"side": "own" | "opponent", "player", "x", "y", "heading", "deviation"}], "own_score", "opponent_score",
/// "seconds_remaining"}. The question is without its id and edit, which who asked knows. Enumerators in small letters:
/// "keep"; nanoseconds as text. Paths and heat only `in_full`.
nlohmann::json to_json(const pb::Forecast& forecast, bool in_full);

/// Fills what was left out, which in a message is 0, and checks the rest: strategies are among those `known`, numbers in
/// the ranges that the .proto states, no robot is moved twice.
Result<pb::WhatIf> complete(pb::WhatIf question, const std::vector<std::string>& known);

/// One sentence where it is not in its range, 0 included.
Result<void> check_horizon(double seconds);
Result<void> check_budget(std::uint32_t budget_ms);

/// "own player 3".
std::string name_of(const pb::WhatIf::MovedRobot& robot);

sim::foresight::Question question_of(const pb::WhatIf& question);

}  // namespace robot::foreseeing
