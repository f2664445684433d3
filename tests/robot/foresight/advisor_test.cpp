#include "robot/foresight/advisor.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <atomic>
#include <functional>
#include <mutex>
#include <thread>
#include <vector>

#include "robot/foresight/question.h"
#include "tests/robot/bridge/played.h"
#include "tests/support/eventually.h"

namespace robot::foreseeing {
namespace {

using Prepare = std::function<void(bridge::test::Played&)>;

/// An advisor in the memory of a robot whose time stands still until a test advances it.
struct Fixture {
  bridge::test::Played game;
  const Prepare prepare;  // changes memory before the advisor sees it
  std::atomic<std::uint64_t> now_ns{game.now_ns()};
  std::atomic<bool> on;
  std::atomic<double> horizon = 5;  // [s]
  std::unique_ptr<Advisor> advisor;

  explicit Fixture(
      bool asks, std::uint32_t budget_ms = 20, Prepare prepared = [](bridge::test::Played&) {})
      : prepare(std::move(prepared)), on(asks) {
    prepare(game);
    advisor = std::make_unique<Advisor>(
        std::move(
            *Foreseer::open({.strategies = {"baseline", "kick_now"}, .rules = "spl2012", .share = Share::background})),
        *game.memory, game.channels, "14/2", [this] { return now_ns.load(); },
        [this, budget_ms] {
          return AskingOptions{.on = on, .period = kPeriod, .budget_ms = budget_ms, .horizon = horizon};
        });
    EXPECT_TRUE(advisor->start());
  }

  /// The forecast that answers `id`, waited for.
  std::shared_ptr<const memory::TypedVersion<pb::Forecast>> answer(std::uint64_t id) {
    std::shared_ptr<const memory::TypedVersion<pb::Forecast>> version;
    const auto newest_id = [&] {
      version = game.memory->forecast.read();
      return version ? version->value().question().id() : 0;
    };
    EXPECT_TRUE(tests::eventually_equal(newest_id, id));
    return version;
  }

  /// Waits for `done`. After an answer without it the captain asks again a period later: a busy machine may play too few
  /// futures, and one of forty answers finds a gain by chance.
  template <class Done>
  void captain_until(Done done) {
    const auto is_done = [&] {
      if (done()) return true;
      const auto version = game.memory->forecast.read();
      if (version && version->value().question().id() == now_ns) go_on();
      return false;
    };
    ASSERT_TRUE(tests::eventually(is_done, 2 * tests::kLongestWait, [&] { return forecast_text(); }));
  }

 private:
  static constexpr double kPeriod = 10;  // [s]

  std::string forecast_text() const {
    const auto version = game.memory->forecast.read();
    return version ? version->value().ShortDebugString() : "no forecast";
  }

  /// Advances time by a period and keeps everything else.
  void go_on() {
    game.timeline.epoch_ns += static_cast<std::uint64_t>(kPeriod * 1e9);
    game.write();
    prepare(game);
    now_ns = game.now_ns();
  }
};

TEST(Advisor, AnswersTheQuestionInMemory) {
  Fixture fixture(false);
  pb::WhatIf question;
  question.set_id(7);
  question.set_budget_ms(20);
  fixture.game.memory->what_if.write(question, fixture.game.now_ns());
  const auto forecast = fixture.answer(7);
  EXPECT_EQ(forecast->value().strategies_size(), 2);
  EXPECT_EQ(forecast->capture_ns(), fixture.game.now_ns()) << "beside the moment it is about";
  EXPECT_EQ(forecast->value().question().asked_by(), kByTeam);
}

TEST(Advisor, AWrongQuestionInMemoryIsAnsweredToo) {
  Fixture fixture(false);
  pb::WhatIf question;
  question.set_id(8);
  question.add_strategies("tiki_taka");
  fixture.game.memory->what_if.write(question, fixture.game.now_ns());
  EXPECT_EQ(fixture.answer(8)->value().refusal(), "no strategy \"tiki_taka\"; there are: baseline, kick_now");
}

/// Keeps all forecasts that memory held.
class Answers final : public memory::Listener {
 public:
  explicit Answers(Fixture& fixture) : forecasts_(fixture.game.memory->forecast) { forecasts_.attach(*this); }
  ~Answers() override { forecasts_.detach(*this); }

  void on_version(const memory::VersionPtr& version) override {
    const std::lock_guard guard(lock_);
    const std::string_view bytes = version->bytes();
    all_.emplace_back().ParseFromArray(bytes.data(), static_cast<int>(bytes.size()));
  }
  std::vector<pb::Forecast> all() const {
    const std::lock_guard guard(lock_);
    return all_;
  }
  /// Waits for `count` forecasts and returns all.
  std::vector<pb::Forecast> first(std::size_t count) const {
    const auto number = [&] { return all().size(); };
    EXPECT_TRUE(tests::eventually([&] { return number() >= count; }, tests::kLongestWait, number));
    return all();
  }

 private:
  memory::MemoryObject<pb::Forecast>& forecasts_;
  mutable Mutex lock_;
  std::vector<pb::Forecast> all_;
};

pb::WhatIf numbered(std::uint64_t id, std::uint32_t budget_ms = 10) {
  pb::WhatIf question;
  question.set_id(id);
  question.set_budget_ms(budget_ms);
  return question;
}

TEST(Advisor, EachNewIdIsOneQuestionAndGetsItsAnswer) {
  Fixture fixture(false);
  const Answers answers(fixture);
  for (std::uint64_t id = 1; id <= 4; ++id)
    fixture.game.memory->what_if.write(numbered(id, 10000), fixture.game.now_ns());
  (void)answers.first(2);  // the refusals come before any answer, because the budget is long
  fixture.advisor->foreseer().hurry();
  const std::vector<pb::Forecast> all = answers.first(4);
  ASSERT_EQ(all.size(), 4u);
  for (std::size_t i = 0; i < 4; ++i) {
    constexpr std::uint64_t kIds[] = {3, 4, 1, 2};  // one runs, one waits, the others are refused at once
    EXPECT_EQ(all[i].question().id(), kIds[i]);
    EXPECT_EQ(all[i].refusal(), i < 2 ? "foresight is busy: one question runs and another one waits" : "");
  }
}

TEST(Advisor, TheSameIdTwiceIsOneQuestion) {
  Fixture fixture(false);
  const Answers answers(fixture);
  for (const std::uint64_t id : {1, 1, 2, 2}) fixture.game.memory->what_if.write(numbered(id), fixture.game.now_ns());
  fixture.answer(2);
  fixture.advisor.reset();
  EXPECT_EQ(answers.all().size(), 2u);
}

bool has_captains(const std::vector<pb::Forecast>& forecasts) {
  return std::ranges::any_of(forecasts, [](const pb::Forecast& forecast) {
    return forecast.question().asked_by().starts_with(kByCaptain) && forecast.refusal().empty();
  });
}

TEST(Advisor, TheCaptainGetsItsTurnWhileOthersAskWithoutPause) {
  for (const bool by_door : {false, true}) {
    Fixture fixture(true);
    const Answers answers(fixture);
    std::atomic<bool> ends = false;
    std::thread people([&] {
      while (!ends) (void)fixture.advisor->ask(numbered(0, 40));
    });
    std::uint64_t id = 0;
    EXPECT_TRUE(tests::eventually(
        [&] {
          if (has_captains(answers.all())) return true;
          if (by_door) fixture.game.memory->what_if.write(numbered(++id, 40), fixture.game.now_ns());
          return false;
        },
        tests::kLongestWait, [&] { return std::to_string(answers.all().size()) + " answers"; }))
        << "by door: " << by_door;
    ends = true;
    people.join();
  }
}

TEST(Advisor, ForecastsOfASimulationAreScoredAgainstGroundTruth) {
  Fixture fixture(false);
  std::uint32_t goals = 0;
  const auto play_on = [&](std::uint64_t seconds) {
    fixture.game.timeline.epoch_ns += seconds * kSecond;
    pb::Simulation simulation;
    simulation.set_tick(100 * goals);
    simulation.mutable_home()->set_number(14);
    simulation.mutable_home()->set_score(goals);
    fixture.game.write();
    fixture.game.memory->simulation.write(simulation, fixture.game.now_ns());
    fixture.now_ns = fixture.game.now_ns();
    // no signal shows that the advisor has read this moment; after a busy machine's pause the test plays on
    std::this_thread::sleep_for(std::chrono::milliseconds(250));
  };
  pb::WhatIf question = numbered(5, 300);
  question.set_horizon(5);
  const auto score = [&] { return fixture.game.memory->forecast_score.read(); };
  // when a busy machine played too few futures, there is another goal
  const auto is_scored = [&] {
    play_on(1);
    EXPECT_TRUE(fixture.advisor->ask(question));
    ++goals;
    play_on(2);
    play_on(4);
    return score() != nullptr;
  };
  ASSERT_TRUE(tests::eventually(is_scored, tests::kLongestWait, [&] { return std::to_string(goals) + " goals"; }));
  EXPECT_EQ(score()->value().against(), pb::ForecastScore::AGAINST_GROUND_TRUTH);
  EXPECT_GE(score()->value().entries(0).score().came(), 1u) << "a goal that the robot did not hear of";
}

TEST(Advisor, TheCaptainAsksByItself) {
  Fixture fixture(true);
  const auto forecast = fixture.answer(fixture.game.now_ns());
  EXPECT_EQ(forecast->value().question().asked_by().find("captain: "), 0u);
  EXPECT_EQ(forecast->value().question().strategies(0), "baseline");
}

TEST(Advisor, MemoryHoldsTheTeamsStrategyAndItsCaptain) {
  Fixture fixture(true, 1000);
  const auto strategy = [&] { return fixture.game.memory->strategy.read(); };
  fixture.captain_until([&] { return strategy() && strategy()->value().chosen(); });
  const auto played = strategy();
  EXPECT_EQ(played->value().captain(), 2u);
  EXPECT_EQ(played->value().name(), fixture.advisor->strategy());
  EXPECT_EQ(played->value().epoch(), 1u) << "the first choice";
}

/// A teammate, player 3, plays the second strategy.
void play_second(bridge::test::Played& game) {
  pb::Team team = game.memory->team.read()->value();
  ASSERT_GT(team.teammates_size(), 0);
  team.mutable_teammates(0)->set_player(3);
  team.mutable_teammates(0)->set_received_ns(game.now_ns());
  team.mutable_teammates(0)->set_strategy(1);
  team.mutable_teammates(0)->set_epoch(44);
  game.memory->team.write(team, game.now_ns());
}

TEST(Advisor, FollowsTheStrategyThatTheCaptainSent) {
  Fixture fixture(false);
  play_second(fixture.game);
  ASSERT_TRUE(tests::eventually_equal([&] { return fixture.advisor->strategy(); }, "kick_now"));
  const auto strategy = [&] { return fixture.game.memory->strategy.read(); };
  ASSERT_TRUE(tests::eventually([&] { return strategy() && strategy()->value().epoch() == 44; }));
  EXPECT_TRUE(strategy()->value().chosen());
}

TEST(Advisor, FollowsTheCaptainWhileQuestionsCome) {
  Fixture fixture(false);
  play_second(fixture.game);
  pb::WhatIf question;
  question.set_budget_ms(10);
  std::uint64_t id = 0;
  const auto strategy = [&] {
    question.set_id(++id);
    fixture.game.memory->what_if.write(question, fixture.game.now_ns());
    std::this_thread::sleep_for(std::chrono::milliseconds(10));  // the pace of the questions
    return fixture.advisor->strategy();
  };
  EXPECT_TRUE(tests::eventually_equal(strategy, "kick_now"));
}

TEST(Advisor, TheCaptainReturnsToTheDefaultWithoutASureGain) {
  Fixture fixture(false, 1000, play_second);
  fixture.horizon = 1;  // hardly anybody scores within a second, by either strategy
  fixture.on = true;
  const auto strategy = [&] { return fixture.game.memory->strategy.read(); };
  fixture.captain_until([&] { return strategy() && strategy()->value().epoch() == 45; });
  EXPECT_EQ(fixture.advisor->strategy(), "baseline");
  const std::string reason = strategy()->value().reason();
  // among many futures there may be one with a goal
  EXPECT_TRUE(reason.starts_with("back to baseline: no difference from kick_now was seen in ") ||
              reason.starts_with("back to baseline: kick_now does not look "))
      << reason;
}

/// Returns the strategy after `change` came during the captain's question and the question was answered.
pb::Strategy played_after(const std::function<void(Fixture&)>& change, double horizon = 5) {
  Fixture fixture(false, 2000, play_second);
  fixture.horizon = horizon;
  fixture.on = true;
  EXPECT_TRUE(tests::eventually([&] { return !fixture.advisor->foreseer().idle(); }));
  EXPECT_TRUE(tests::eventually_equal([&] { return fixture.advisor->strategy(); }, "kick_now"));
  change(fixture);
  EXPECT_EQ(fixture.answer(fixture.now_ns)->value().refusal(), "");
  fixture.advisor.reset();
  return fixture.game.memory->strategy.read()->value();
}

TEST(Advisor, ARobotThatIsNoLongerCaptainAtTheAnswerDoesNotChoose) {
  const pb::Strategy played = played_after([](Fixture& fixture) {
    pb::GameState game = fixture.game.memory->game.read()->value();
    game.mutable_own()->mutable_players(1)->set_penalised(true);
    fixture.game.memory->game.write(game, fixture.game.now_ns());
  });
  EXPECT_EQ(played.name(), "kick_now");
  EXPECT_EQ(played.epoch(), 44u);
}

TEST(Advisor, ARobotWhoseForesightIsOffAtTheAnswerDoesNotChoose) {
  const pb::Strategy played = played_after([](Fixture& fixture) { fixture.on = false; });
  EXPECT_EQ(played.name(), "kick_now");
  EXPECT_EQ(played.epoch(), 44u);
}

/// Eight futures of two strategies are sixteen halves, which take longer than this test gives them.
TEST(Advisor, AnAnswerWithoutAdviceLeavesTheChoiceAsItIs) {
  const pb::Strategy played = played_after(
      [](Fixture& fixture) {
        fixture.advisor->foreseer().hurry();
        EXPECT_EQ(fixture.answer(fixture.now_ns)->value().advice(), pb::Forecast::ADVICE_NONE);
      },
      1200);
  EXPECT_EQ(played.name(), "kick_now");
  EXPECT_EQ(played.epoch(), 44u);
}

TEST(Advisor, TheCallerAndMemoryGetTheSameAnswer) {
  Fixture fixture(false);
  pb::WhatIf question;
  question.set_id(9);
  question.set_budget_ms(20);
  const auto forecast = fixture.advisor->ask(question);
  ASSERT_TRUE(forecast) << forecast.error();
  EXPECT_EQ(fixture.answer(9)->value().reason(), forecast->reason());
  EXPECT_EQ(fixture.advisor->strategy(), "baseline") << "what people ask changes nothing";
}

TEST(Advisor, EndsWhileTheCaptainsQuestionIsAnswered) {
  for (int i = 0; i < 60; ++i) {
    Fixture fixture(true);
    std::this_thread::sleep_for(std::chrono::milliseconds(i));  // each run ends at another moment of the question
  }
}

TEST(Advisor, EndsInTheMiddleOfAQuestion) {
  for (int i = 0; i < 20; ++i) {
    Fixture fixture(true);
    pb::WhatIf question;
    question.set_id(10);
    question.set_budget_ms(10);
    fixture.game.memory->what_if.write(question, fixture.game.now_ns());
    std::this_thread::sleep_for(std::chrono::milliseconds(i));  // each run ends at another moment of the question
  }
}

}  // namespace
}  // namespace robot::foreseeing
