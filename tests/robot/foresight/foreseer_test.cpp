#include "robot/foresight/foreseer.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <future>
#include <optional>
#include <vector>

#include "robot/core/clock.h"
#include "robot/core/json_library.h"
#include "robot/foresight/question.h"
#include "sim/referee/referee.h"
#include "tests/robot/bridge/played.h"

namespace robot::foreseeing {
namespace {

std::unique_ptr<Foreseer> foreseer(std::vector<std::string> strategies = {"baseline", "kick_now", "passing"}) {
  auto opened = Foreseer::open({.strategies = std::move(strategies), .rules = "spl2012", .share = Share::background});
  if (!opened) {
    ADD_FAILURE() << opened.error();
    return nullptr;
  }
  return std::move(*opened);
}

pb::WhatIf question(std::uint32_t budget_ms = 100) {
  pb::WhatIf asked;
  asked.set_budget_ms(budget_ms);
  asked.set_horizon(10);
  return asked;
}

TEST(Foreseer, AnswersAtTheDeadlineWithWhatItHas) {
  const bridge::test::Played game;
  const auto foresight = foreseer();
  const auto forecast = foresight->ask_and_wait(question(300), game.recollection());
  ASSERT_TRUE(forecast) << forecast.error();
  EXPECT_EQ(forecast->refusal(), "");
  ASSERT_EQ(forecast->strategies_size(), 3);
  EXPECT_EQ(forecast->strategies(0).strategy(), "baseline");
  EXPECT_EQ(forecast->strategies(2).strategy(), "passing");
  EXPECT_GE(forecast->answered_ms(), 300);
  EXPECT_EQ(forecast->asked_ns(), game.now_ns());
  EXPECT_EQ(forecast->situation().bodies_size() > 0, true);
  EXPECT_FALSE(forecast->reason().empty());
  // on a machine of any load the answer fits its rollouts
  const bool enough = forecast->strategies(0).rollouts() >= 8;
  EXPECT_EQ(forecast->advice() == pb::Forecast::ADVICE_NONE, !enough) << forecast->reason();
  EXPECT_LE(forecast->computed_ms(), forecast->answered_ms());
}

TEST(Foreseer, ReportsTheMomentWhereRolloutsStart) {
  const bridge::test::Played game;
  const auto foresight = foreseer();
  pb::WhatIf asked = question(10);
  asked.set_asked_by("a test");
  asked.mutable_edit()->mutable_ball()->set_x(0.5f);
  asked.mutable_edit()->set_own_score(2);
  asked.mutable_edit()->set_opponent_score(1);
  asked.mutable_edit()->set_seconds_remaining(90);
  const auto forecast = foresight->ask_and_wait(asked, game.recollection());
  ASSERT_TRUE(forecast) << forecast.error();
  const pb::Forecast::Situation& situation = forecast->situation();
  EXPECT_EQ(situation.ball_x(), 0.5f);
  EXPECT_EQ(situation.ball_elsewhere(), 0) << "it is where the question puts it";
  EXPECT_EQ(situation.own_score(), 2u);
  EXPECT_EQ(situation.opponent_score(), 1u);
  EXPECT_NEAR(situation.seconds_remaining(), 90, 1e-3);
  const auto told = to_json(*forecast, false);
  EXPECT_EQ(told["question"]["strategies"], (nlohmann::json{"baseline", "kick_now", "passing"}));
  EXPECT_EQ(told["question"]["asked_by"], "a test");
  EXPECT_EQ(told["situation"]["own_score"], 2);
  EXPECT_EQ(told["situation"]["ball"]["elsewhere"], 0);
}

TEST(Foreseer, ReportsTheHorizon) {
  const bridge::test::Played game;
  const auto foresight = foreseer();
  const auto horizon = [&](pb::WhatIf::Until until, std::optional<float> remaining = 90) {
    pb::WhatIf asked = question(10);
    asked.set_until(until);
    if (remaining) asked.mutable_edit()->set_seconds_remaining(*remaining);
    const auto forecast = foresight->ask_and_wait(asked, game.recollection());
    return forecast ? forecast->horizon() : -1;
  };
  const sim::field::Rules& rules = game.setup.params.rules;
  EXPECT_EQ(horizon(pb::WhatIf::UNTIL_HORIZON), 10);
  EXPECT_EQ(horizon(pb::WhatIf::UNTIL_NEXT_GOAL), 10);
  EXPECT_NEAR(horizon(pb::WhatIf::UNTIL_HALF), 90, 1e-3);
  EXPECT_NEAR(horizon(pb::WhatIf::UNTIL_HALF, {}), sim::referee::left_of_half(rules, game.state.book), 1e-3);
  EXPECT_NEAR(horizon(pb::WhatIf::UNTIL_GAME), 90 + rules.ready_duration + rules.set_duration + rules.half_duration,
              1e-3);
}

TEST(Foreseer, ReportsItsModelsAndRules) {
  const bridge::test::Played game;
  auto opened = Foreseer::open(
      {.strategies = {"baseline"}, .rules = "spl2012", .models = "perfect", .opponent_models = "friendly"});
  ASSERT_TRUE(opened) << opened.error();
  auto forecast = (*opened)->ask_and_wait(question(10), game.recollection());
  ASSERT_TRUE(forecast) << forecast.error();
  EXPECT_EQ(forecast->models(), "perfect");
  EXPECT_EQ(forecast->opponent_models(), "friendly");
  EXPECT_EQ(forecast->rules(), "spl2012");
  const auto told = to_json(*forecast, false);
  EXPECT_EQ(told["models"], "perfect");
  EXPECT_EQ(told["opponent_models"], "friendly");
  EXPECT_EQ(told["rules"], "spl2012");
  forecast = (*opened)->ask_and_wait(question(10), {});
  ASSERT_TRUE(forecast) << forecast.error();
  EXPECT_NE(forecast->refusal(), "");
  EXPECT_EQ(forecast->opponent_models(), "friendly") << "a refusal holds it, too";
}

TEST(Foreseer, ForARobotOfTheOpponentsItExchangesTheModels) {
  EXPECT_EQ(whose("14/3", "14/2"), Whose::own);
  EXPECT_EQ(whose("1/2", "14/2"), Whose::others);
  const bridge::test::Played game;
  auto opened = Foreseer::open(
      {.strategies = {"baseline"}, .rules = "spl2012", .models = "perfect", .opponent_models = "friendly"});
  ASSERT_TRUE(opened) << opened.error();
  const auto forecast = (*opened)->ask_and_wait(question(10), game.recollection(), Whose::others);
  ASSERT_TRUE(forecast) << forecast.error();
  EXPECT_EQ(forecast->models(), "friendly");
  EXPECT_EQ(forecast->opponent_models(), "perfect");
}

TEST(Foreseer, NamesAllByTheirJerseys) {
  const bridge::test::Played game;
  const auto foresight = foreseer();
  pb::WhatIf asked = question(200);
  pb::WhatIf::MovedRobot& moved = *asked.mutable_edit()->add_robots();
  moved.set_player(14);
  moved.set_x(-1.25f);
  moved.set_y(1.5f);
  const auto forecast = foresight->ask_and_wait(asked, bridge::test::renumbered(game.recollection()));
  ASSERT_TRUE(forecast) << forecast.error();
  const auto is_number = [](std::uint32_t player) {
    return std::ranges::find(bridge::test::kNumbers, player) != std::end(bridge::test::kNumbers);
  };
  bool seen = false;
  for (const auto& body : forecast->situation().bodies()) {
    EXPECT_TRUE(is_number(body.player())) << body.player();
    if (body.opponent() || body.player() != 14) continue;
    seen = true;
    EXPECT_EQ(body.x(), -1.25f);
    EXPECT_EQ(body.y(), 1.5f);
  }
  EXPECT_TRUE(seen);
  for (const auto& strategy : forecast->strategies())
    for (const auto& path : strategy.paths())
      for (const auto& robot : path.robots()) EXPECT_TRUE(is_number(robot.player())) << robot.player();
  moved.set_player(3);
  EXPECT_EQ(foresight->ask_and_wait(asked, bridge::test::renumbered(game.recollection())).error(),
            "own player 3 does not play: players are 9, 12, 14, 20");
}

/// A robot that has not seen the ball for a while expects it elsewhere in some of its futures.
TEST(Foreseer, SaysHowLikelyTheBallIsElsewhere) {
  const bridge::test::Played game;
  const auto foresight = foreseer();
  const auto elsewhere = [&](std::uint64_t seen_ns) {
    pb::Ball ball = game.memory->ball.read()->value();
    ball.set_seen_ns(seen_ns);
    game.memory->ball.write(ball, game.now_ns());
    bridge::Recollection from = game.recollection();
    from.team.reset();  // and no teammate has reported it
    const auto forecast = foresight->ask_and_wait(question(10), from);
    EXPECT_TRUE(forecast) << forecast.error();
    EXPECT_EQ(forecast->refusal(), "");
    return forecast->situation().ball_elsewhere();
  };
  EXPECT_GT(elsewhere(game.now_ns() - 5'000'000'000), elsewhere(game.now_ns()));
}

TEST(Foreseer, OneQuestionRunsOneWaitsAndTheThirdIsRefused) {
  const bridge::test::Played game;
  const auto foresight = foreseer();
  std::vector<std::promise<void>> answered(2);
  for (std::promise<void>& one : answered)
    ASSERT_TRUE(
        foresight->ask(question(10'000), game.recollection(), [&one](const pb::Forecast&) { one.set_value(); }));
  const auto third = foresight->ask(question(), game.recollection(), [](const pb::Forecast&) { FAIL(); });
  ASSERT_FALSE(third);
  EXPECT_EQ(third.error(), "foresight is busy: one question runs and another one waits");
  foresight->hurry();  // the budget was long, so that both questions were open at the third one
  for (std::promise<void>& one : answered) one.get_future().wait();
  EXPECT_TRUE(foresight->ask_and_wait(question(10), game.recollection()));
}

TEST(Foreseer, TheAnswersTimeIncludesTheWait) {
  const bridge::test::Played game;
  const auto foresight = foreseer();
  EXPECT_TRUE(foresight->idle());
  std::promise<std::uint64_t> first_ends;  // [monotonic]
  std::promise<float> waited;              // [ms]
  ASSERT_TRUE(foresight->ask(question(200), game.recollection(),
                             [&](const pb::Forecast&) { first_ends.set_value(monotonic_ns()); }));
  ASSERT_TRUE(foresight->ask(question(50), game.recollection(),
                             [&](const pb::Forecast& forecast) { waited.set_value(forecast.answered_ms()); }));
  const auto asked_ns = static_cast<double>(monotonic_ns());
  const double other_ms = (static_cast<double>(first_ends.get_future().get()) - asked_ns) / 1e6;
  EXPECT_GE(waited.get_future().get(), std::max(other_ms, 0.) + 50) << "its own 50 ms begin when the other has ended";
}

TEST(Foreseer, AfterHurryEveryQuestionIsAnsweredAtOnce) {
  const bridge::test::Played game;
  const auto foresight = foreseer();
  std::promise<pb::Forecast> first, second;
  ASSERT_TRUE(foresight->ask(question(10'000), game.recollection(),
                             [&](const pb::Forecast& forecast) { first.set_value(forecast); }));
  ASSERT_TRUE(foresight->ask(question(10'000), game.recollection(),
                             [&](const pb::Forecast& forecast) { second.set_value(forecast); }));
  foresight->hurry();
  EXPECT_LT(first.get_future().get().answered_ms(), 10'000);
  EXPECT_LT(second.get_future().get().answered_ms(), 10'000);
}

TEST(Foreseer, EditedThingsNeedNotHaveBeenSeen) {
  const bridge::test::Played game;
  const auto foresight = foreseer();
  bridge::Recollection from = game.recollection();
  from.ball.reset();
  from.team.reset();
  from.pose->value.set_deviation_x(5);
  pb::WhatIf asked = question(10);
  EXPECT_NE(foresight->ask_and_wait(asked, from)->refusal(), "") << "lost";
  pb::WhatIf::MovedRobot& self = *asked.mutable_edit()->add_robots();
  self.set_player(2);
  self.set_x(-1);
  EXPECT_EQ(foresight->ask_and_wait(asked, from)->refusal(), "nobody has seen the ball yet");
  asked.mutable_edit()->mutable_ball()->set_x(1);
  const auto forecast = foresight->ask_and_wait(asked, from);
  ASSERT_TRUE(forecast) << forecast.error();
  EXPECT_EQ(forecast->refusal(), "");
  EXPECT_EQ(forecast->situation().ball_x(), 1);
}

TEST(Foreseer, ARefusalIsAnAnswer) {
  const bridge::test::Played game;
  const auto foresight = foreseer();
  bridge::Recollection from = game.recollection();
  from.pose.reset();
  const auto forecast = foresight->ask_and_wait(question(), from);
  ASSERT_TRUE(forecast);
  EXPECT_EQ(forecast->advice(), pb::Forecast::ADVICE_NONE);
  EXPECT_EQ(forecast->reason(),
            "cannot tell, because the robot does not know where it is: there is no object pose yet");
  EXPECT_EQ(forecast->choice(), "baseline");
}

TEST(Foreseer, AWrongQuestionIsRefusedAndNothingRuns) {
  const bridge::test::Played game;
  const auto foresight = foreseer();
  pb::WhatIf nonsense = question();
  nonsense.add_strategies("tiki_taka");
  EXPECT_FALSE(foresight->ask_and_wait(nonsense, game.recollection()));
  pb::WhatIf absurd = question();
  absurd.mutable_edit()->mutable_ball()->set_x(1e9f);
  EXPECT_FALSE(foresight->ask_and_wait(absurd, game.recollection()));
  EXPECT_TRUE(foresight->ask_and_wait(question(10), game.recollection()));
}

TEST(Foreseer, EndsInTheMiddleOfAQuestion) {
  const bridge::test::Played game;
  auto foresight = foreseer();
  ASSERT_TRUE(foresight->ask(question(10'000), game.recollection(), [](const pb::Forecast&) {}));
  foresight.reset();
}

TEST(Foreseer, StrategiesAreReadWhenItIsOpened) {
  EXPECT_EQ(Foreseer::open({.strategies = {"baseline", "nonsuch"}}).error().find("foresight: no strategy 'nonsuch'"),
            0u);
  EXPECT_EQ(Foreseer::open({.strategies = std::vector<std::string>(9, "baseline")}).error(),
            "foresight: strategies must be 1 .. 8, got 9");
  EXPECT_FALSE(Foreseer::open({.strategies = {}}));
  EXPECT_FALSE(Foreseer::open({.strategies = {"baseline"}, .rules = "spl1997"}));
}

}  // namespace
}  // namespace robot::foreseeing
