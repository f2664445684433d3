// Questions and answers of foresight as JSON, and the checks of a question.
#pragma once

#include <cstdint>
#include <nlohmann/json_fwd.hpp>
#include <string>
#include <string_view>
#include <vector>

#include "proto/foresight/forecast.pb.h"
#include "robot/core/result.h"
#include "sim/foresight/question.h"

namespace robot::foreseeing {

namespace pb = ::foresight;

/// The beginning of `asked_by` when people or the captain asked, and its value for a team's process that gives no name.
inline constexpr std::string_view kByPeople = "people", kByCaptain = "captain: ", kByTeam = "the team's code";

/// The opponents' strategy when the question names none.
inline constexpr const char* kDefaultOpponent = "baseline";

/// {"strategies": ["baseline", "passing"], "opponent": "baseline",
///  "measure": "goal_difference" | "score_next" | "concede", "until": "horizon" | "next_goal" | "half" | "game",
///  "horizon": 30, "budget_ms": 500, "switching_cost": 0.02, "sure": 0.9,
///  "edit": {"ball": {"x", "y"}, "robots": [{"side": "own" | "opponent", "player", "x", "y", "heading"}],
///           "own_score", "opponent_score", "seconds_remaining"}}
///
/// Parses a question. All members are optional. Units are metres and radians of team_field, and seconds. Returns an
/// Error for an unknown member, and for a 0 where a message would take it for absent.
Result<pb::WhatIf> parse_question(const nlohmann::json& json);

/// Returns the fields of the message by their names, except the situation: {"ball": {"x", "y", "deviation",
/// "elsewhere"}, "robots": [{"side": "own" | "opponent", "player", "x", "y", "heading", "deviation"}], "own_score",
/// "opponent_score", "seconds_remaining"}. The question has no id and no edit, because the asker knows them.
/// Enumerators are in small letters ("keep"), nanoseconds are text. Paths and heat come only `in_full`.
nlohmann::json to_json(const pb::Forecast& forecast, bool in_full);

/// Fills absent fields, which are 0 in a message, and checks the others. Strategies must be among `known`, numbers in
/// the ranges that the .proto states. No robot may be moved twice.
Result<pb::WhatIf> complete(pb::WhatIf question, const std::vector<std::string>& known);

/// Each returns an Error when the value is out of its range. 0 is out of range.
Result<void> check_horizon(double seconds);
Result<void> check_budget(std::uint32_t budget_ms);

/// Returns the robot's name, such as "own player 3".
std::string name_of(const pb::WhatIf::MovedRobot& robot);

sim::foresight::Question question_of(const pb::WhatIf& question);

}  // namespace robot::foreseeing
