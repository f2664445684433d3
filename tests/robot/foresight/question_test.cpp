#include "robot/foresight/question.h"
#include "robot/core/json_library.h"

#include <gtest/gtest.h>

#include <limits>

namespace robot::foreseeing {
namespace {

const std::vector<std::string> kKnown = {"baseline", "passing", "kick_now"};

std::string problem(const char* text) {
  const auto json = nlohmann::json::parse(text);
  auto question = parse_question(json);
  if (!question) return question.error();
  const auto completed = complete(*question, kKnown);
  return completed ? "" : completed.error();
}

TEST(Question, EverythingMayBeLeftOut) {
  const auto question = complete(*parse_question(nlohmann::json::object()), kKnown);
  ASSERT_TRUE(question) << question.error();
  EXPECT_EQ(question->strategies_size(), 3);
  EXPECT_EQ(question->strategies(0), "baseline");
  EXPECT_EQ(question->opponent(), "baseline");
  EXPECT_EQ(question->horizon(), 30);
  EXPECT_EQ(question->budget_ms(), 500u);
  const auto asked = question_of(*question);
  EXPECT_EQ(asked.horizon, sim::ticks(30));
  EXPECT_EQ(asked.measure, sim::foresight::Measure::goal_difference);
}

TEST(Question, TheOpponentsPlayTheBaselineByDefault) {
  const auto question = complete({}, {"mine.json"});
  ASSERT_TRUE(question) << question.error();
  EXPECT_EQ(question->strategies(0), "mine.json");
  EXPECT_EQ(question->opponent(), "baseline");
}

TEST(Question, WholeNumbersMayBeSpelledAsDecimalFractions) {
  const auto question = parse_question(nlohmann::json::parse(R"({"budget_ms": 250.0, "edit": {"own_score": 2e0}})"));
  ASSERT_TRUE(question) << question.error();
  EXPECT_EQ(question->budget_ms(), 250u);
  EXPECT_EQ(question->edit().own_score(), 2u);
}

TEST(Question, SaysWhatIsWrong) {
  EXPECT_EQ(problem(R"({"horizn": 3})"), "'horizn' is no member of a question");
  EXPECT_EQ(problem(R"({"horizon": "far"})"), "'horizon' must be a number, got \"far\"");
  EXPECT_EQ(problem(R"({"horizon": 1e9})"), "'horizon' must be 1 .. 1200 [s], got 1e+09");
  EXPECT_EQ(problem(R"({"horizon": -3})"), "'horizon' must be 1 .. 1200 [s], got -3");
  EXPECT_EQ(problem(R"({"horizon": 0})"), "'horizon' must be 1 .. 1200 [s], got 0");
  EXPECT_EQ(problem(R"({"horizon": 1e-60})"), "'horizon' must be 1 .. 1200 [s], got 1e-60");
  EXPECT_EQ(problem(R"({"budget_ms": 0})"), "'budget_ms' must be 10 .. 10000 [ms], got 0");
  EXPECT_EQ(problem(R"({"budget_ms": 1000000000})"), "'budget_ms' must be 10 .. 10000 [ms], got 1000000000");
  EXPECT_EQ(problem(R"({"budget_ms": 10.5})"), "'budget_ms' must be a whole number 0 .. 1000000000, got 10.5");
  EXPECT_EQ(problem(R"({"budget_ms": -1})"), "'budget_ms' must be a whole number 0 .. 1000000000, got -1");
  EXPECT_EQ(problem(R"({"rollouts": 1000000000})"), "'rollouts' is no member of a question");
  EXPECT_EQ(problem(R"({"strategies": ["baseline", "tiki_taka"]})"),
            "no strategy \"tiki_taka\"; there are: baseline, passing, kick_now");
  EXPECT_EQ(problem(R"({"strategies": ["/etc/passwd"]})"),
            "no strategy \"/etc/passwd\"; there are: baseline, passing, kick_now");
  EXPECT_EQ(problem(R"({"opponent": "x"})"), "no strategy \"x\"; there are: baseline, passing, kick_now");
  EXPECT_EQ(problem(R"({"strategies": ["passing", "passing"]})"), "'strategies' must differ, passing occurs twice");
  EXPECT_EQ(problem(R"({"strategies": "baseline"})"), "'strategies' must be a list of names, got \"baseline\"");
  EXPECT_EQ(problem(R"({"measure": "fun"})"),
            "'measure' must be one of goal_difference, score_next, concede, got \"fun\"");
  EXPECT_EQ(problem(R"({"until": 3})"), "'until' must be one of horizon, next_goal, half, game, got 3");
  EXPECT_EQ(problem(R"({"switching_cost": -1})"), "'switching_cost' must be 0 .. 10, got -1");
  EXPECT_EQ(problem(R"({"sure": 1})"), "'sure' must be 0.5 .. 0.999, got 1");
  EXPECT_EQ(problem(R"({"edit": []})"), "'edit' must be an object, got []");
  EXPECT_EQ(problem(R"({"edit": {"ball": {"x": 1}}})"), "'edit.ball.y' is missing");
  EXPECT_EQ(problem(R"({"edit": {"robots": [{"side": "theirs", "player": 1, "x": 0, "y": 0}]}})"),
            "'edit.robots[0].side' must be own or opponent, got \"theirs\"");
  EXPECT_EQ(problem(R"({"edit": {"robots": [{"side": "own", "x": 0, "y": 0}]}})"),
            "'edit.robots[0].player' is missing");
  EXPECT_EQ(problem(R"({"edit": {"robots": [{"side": "own", "player": 2, "x": 0, "y": 0},
                                            {"side": "opponent", "player": 2, "x": 1, "y": 0},
                                            {"side": "own", "player": 2, "x": 2, "y": 0}]}})"),
            "'edit.robots' must differ, own player 2 occurs twice");
  EXPECT_EQ(problem("[]"), "a question must be an object, got []");
}

TEST(Question, OfAMessageIsCheckedAsWell) {
  pb::WhatIf question;
  question.set_horizon(std::numeric_limits<float>::quiet_NaN());
  EXPECT_FALSE(complete(question, kKnown));
  question.Clear();
  question.set_measure(static_cast<pb::WhatIf::Measure>(77));
  EXPECT_EQ(complete(question, kKnown).error(), "'measure' must be a value of foresight.WhatIf.Measure, got 77");
  question.Clear();
  for (std::uint32_t player = 1; player <= 15; ++player) question.mutable_edit()->add_robots()->set_player(player);
  EXPECT_EQ(complete(question, kKnown).error(), "'edit.robots' must be at most 14, got 15");
  question.mutable_edit()->mutable_robots()->RemoveLast();
  EXPECT_TRUE(complete(question, kKnown));
}

TEST(Question, OfAMessageMayLeaveOutByZero) {
  pb::WhatIf question;
  question.set_horizon(0);
  question.set_budget_ms(0);
  const auto completed = complete(question, kKnown);
  ASSERT_TRUE(completed) << completed.error();
  EXPECT_EQ(completed->horizon(), 30);
  EXPECT_EQ(completed->budget_ms(), 500u);
}

}  // namespace
}  // namespace robot::foreseeing
