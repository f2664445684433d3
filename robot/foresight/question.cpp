#include "robot/foresight/question.h"

#include <algorithm>

#include "robot/core/json.h"
#include "robot/core/json_library.h"
#include "robot/core/text.h"
#include "sim/foresight/rollout_statistics.h"

namespace robot::foreseeing {
namespace {

constexpr float kDefaultHorizon = 30;     // [s]
constexpr double kLongestHorizon = 1200;  // [s]
constexpr std::uint32_t kDefaultBudgetMs = 500, kLeastBudgetMs = 10, kMostBudgetMs = 10'000;
constexpr float kDefaultCost = 0.02f;
constexpr float kDefaultSure = 0.9f;
constexpr std::size_t kMostName = 200;

/// Checks that all strategies are known and none occurs twice.
Result<void> check_names(const pb::WhatIf& question, const std::vector<std::string>& known) {
  if (question.strategies_size() > sim::foresight::kMaxStrategies)
    return Error{"'strategies' must be 1 .. " + std::to_string(sim::foresight::kMaxStrategies) + ", got " +
                 std::to_string(question.strategies_size())};
  std::string all;
  for (const std::string& name : known) all += (all.empty() ? "" : ", ") + name;
  const auto check = [&](const std::string& name) -> Result<void> {
    if (std::find(known.begin(), known.end(), name) != known.end()) return {};
    return Error{"no strategy " + shown(name.substr(0, kMostName)) + "; there are: " + all};
  };
  for (int i = 0; i < question.strategies_size(); ++i) {
    const std::string& name = question.strategies(i);
    if (Result<void> checked = check(name); !checked) return checked;
    if (std::find(question.strategies().begin(), question.strategies().begin() + i, name) !=
        question.strategies().begin() + i)
      return Error{"'strategies' must differ, " + name + " occurs twice"};
  }
  // baseline always exists, whatever the own team plays
  return question.opponent() == kDefaultOpponent ? Result<void>{} : check(question.opponent());
}

/// Checks the number of moved robots, and that each is moved once.
Result<void> check_moved(const google::protobuf::RepeatedPtrField<pb::WhatIf::MovedRobot>& robots) {
  if (robots.size() > sim::kMaxRobots)
    return Error{"'edit.robots' must be at most " + std::to_string(sim::kMaxRobots) + ", got " +
                 std::to_string(robots.size())};
  for (auto robot = robots.begin(); robot != robots.end(); ++robot)
    if (std::any_of(robots.begin(), robot, [&](const pb::WhatIf::MovedRobot& before) {
          return before.opponent() == robot->opponent() && before.player() == robot->player();
        }))
      return Error{"'edit.robots' must differ, " + name_of(*robot) + " occurs twice"};
  return {};
}

}  // namespace

std::string name_of(const pb::WhatIf::MovedRobot& robot) {
  return std::string(robot.opponent() ? "opponent player " : "own player ") + std::to_string(robot.player());
}

Result<void> check_horizon(double seconds) {
  if (seconds >= 1 && seconds <= kLongestHorizon) return {};
  return Error{formatted("'horizon' must be 1 .. 1200 [s], got %g", seconds)};
}

Result<void> check_budget(std::uint32_t budget_ms) {
  if (budget_ms >= kLeastBudgetMs && budget_ms <= kMostBudgetMs) return {};
  return Error{"'budget_ms' must be 10 .. 10000 [ms], got " + std::to_string(budget_ms)};
}

Result<pb::WhatIf> complete(pb::WhatIf question, const std::vector<std::string>& known) {
  if (question.strategies_size() == 0)
    for (std::size_t i = 0; i < std::min<std::size_t>(known.size(), sim::foresight::kMaxStrategies); ++i)
      question.add_strategies(known[i]);
  if (question.opponent().empty()) question.set_opponent(kDefaultOpponent);
  if (question.horizon() == 0) question.set_horizon(kDefaultHorizon);
  if (question.budget_ms() == 0) question.set_budget_ms(kDefaultBudgetMs);
  if (!question.has_switching_cost()) question.set_switching_cost(kDefaultCost);
  if (!question.has_sure()) question.set_sure(kDefaultSure);

  if (Result<void> named = check_names(question, known); !named) return named.failure();
  if (!pb::WhatIf::Measure_IsValid(question.measure()))
    return Error{"'measure' must be a value of foresight.WhatIf.Measure, got " +
                 std::to_string(static_cast<int>(question.measure()))};
  if (!pb::WhatIf::Until_IsValid(question.until()))
    return Error{"'until' must be a value of foresight.WhatIf.Until, got " +
                 std::to_string(static_cast<int>(question.until()))};
  if (Result<void> checked = check_horizon(double{question.horizon()}); !checked) return checked.failure();
  if (Result<void> checked = check_budget(question.budget_ms()); !checked) return checked.failure();
  if (Result<void> moved = check_moved(question.edit().robots()); !moved) return moved.failure();
  if (!(question.switching_cost() >= 0 && question.switching_cost() <= 10))
    return Error{formatted("'switching_cost' must be 0 .. 10, got %g", static_cast<double>(question.switching_cost()))};
  if (!(question.sure() >= 0.5f && question.sure() <= 0.999f))
    return Error{formatted("'sure' must be 0.5 .. 0.999, got %g", static_cast<double>(question.sure()))};
  return question;
}

sim::foresight::Question question_of(const pb::WhatIf& question) {
  return {.own = sim::Side::home,
          .measure = static_cast<sim::foresight::Measure>(question.measure()),
          .until = static_cast<sim::foresight::Until>(question.until()),
          .horizon = sim::ticks(question.horizon()),
          .switching_cost = question.switching_cost(),
          .sure = question.sure()};
}

}  // namespace robot::foreseeing
