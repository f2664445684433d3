#include "robot/app/lab_foresight.h"

#include <gtest/gtest.h>

#include "robot/body/replay/replay.h"
#include "robot/logging/sessions/session_writer.h"
#include "tests/robot/bridge/played.h"
#include "tests/support/temporary_folder.h"

namespace robot::app {
namespace {

/// A recording of 14/2 with two moments of a game, ten seconds apart, and no messages between.
struct LabForesightOf : ::testing::Test {
  LabForesightOf() {
    bridge::test::Played game;
    auto writer = logging::SessionWriter::create(folder / "game", {.robot = "14/2", .team = 14, .player = 2});
    EXPECT_TRUE(writer);
    for (Moment& moment : moments) {
      sim::referee::Events events;
      for (int tick = 0; tick < 300; ++tick) sim::step(game.setup.params, game.state, events);
      game.write();
      for (const auto& channel : game.channels.all()) {
        const auto newest = channel->newest();
        if (!newest || channel->info().topic == memory::kSimulationTopic) continue;
        EXPECT_TRUE((*writer)->write(channel->info(), game.now_ns(), newest->bytes()));
      }
      moment = {.at_ns = game.now_ns(), .ball_x = ball_of(game).x, .score = game.state.book.score[0]};
      moment.remaining = game.memory->game.read()->value().seconds_remaining();
    }
    EXPECT_TRUE((*writer)->close());
    auto opened = body::Replay::open({folder / "game"}, {.shifts = {kShift}});
    EXPECT_TRUE(opened) << opened.error();
    replay = std::move(*opened);
  }

  static sim::Vec2 ball_of(const bridge::test::Played& game) {
    const sim::agent::Beliefs& beliefs = game.state.robots[1].beliefs;
    return beliefs.pose.pose.position + sim::turned(beliefs.ball.position, sim::direction(beliefs.pose.pose.heading));
  }

  Result<foresight::Forecast> ask(std::uint64_t at_ns, const std::string& robot = "14/2",
                                  std::uint32_t budget_ms = 10) {
    foresight::WhatIf question;
    question.set_budget_ms(budget_ms);
    return lab.ask([&](const std::string& topic) { return replay->stream_of(topic); }, robot, question, at_ns);
  }

  static constexpr std::int64_t kShift = -350'000'000;
  static std::uint64_t played(std::uint64_t at_ns) { return at_ns + static_cast<std::uint64_t>(kShift); }

  struct Moment {
    std::uint64_t at_ns = 0;
    float ball_x = 0, remaining = 0;
    int score = 0;
  };
  Moment moments[2];
  const tests::TemporaryFolder folder;
  std::unique_ptr<body::Replay> replay;  // not started: no stream has played a message
  LabForesight lab{{.rules = "spl2012", .strategies = {}}};
};

TEST_F(LabForesightOf, AnswersFromTheValuesRecordedBeforeTheMomentWhereverThePlaybackIs) {
  for (const int i : {1, 0, 1}) {
    const std::uint64_t at_ns = played(moments[i].at_ns);
    const auto forecast = ask(at_ns);
    ASSERT_TRUE(forecast) << forecast.error();
    EXPECT_EQ(forecast->refusal(), "");
    EXPECT_EQ(forecast->asked_ns(), at_ns);
    EXPECT_NEAR(forecast->situation().seconds_remaining(), moments[i].remaining, 1);
    EXPECT_NEAR(forecast->situation().ball_x(), moments[i].ball_x, 0.05) << i;
  }
  EXPECT_GT(moments[0].remaining - moments[1].remaining, 5);

  // half a second later there is no newer value
  const auto later = ask(played(moments[0].at_ns) + kSecond / 2);
  ASSERT_TRUE(later) << later.error();
  EXPECT_NEAR(later->situation().seconds_remaining(), moments[0].remaining, 1);
}

TEST_F(LabForesightOf, LaterValuesAreUnknown) {
  const auto forecast = ask(played(moments[0].at_ns) - 1);
  ASSERT_TRUE(forecast) << forecast.error();
  EXPECT_EQ(forecast->refusal(), "the robot does not know of a game: there is no object game yet");
}

TEST_F(LabForesightOf, RefusesARobotThatIsNotInTheRecording) {
  EXPECT_EQ(ask(played(moments[0].at_ns), "77/1").error(), "there is no robot '77/1'");
}

TEST_F(LabForesightOf, AfterHurryAnswersWithTheRolloutsDoneSoFar) {
  lab.hurry();
  const auto forecast = ask(played(moments[0].at_ns), "14/2", 10'000);
  ASSERT_TRUE(forecast) << forecast.error();
  EXPECT_LT(forecast->answered_ms(), 9'000);
}

TEST_F(LabForesightOf, TheCommandGivesTheSameAnswer) {
  WhatIfOptions options{.session = folder / "game", .robot = "", .at = 10, .foresight = {.rules = "spl2012"}};
  options.question.set_budget_ms(10);
  const auto forecast = what_if(options);
  ASSERT_TRUE(forecast) << forecast.error();
  EXPECT_NEAR(forecast->situation().seconds_remaining(), moments[1].remaining, 1);
  options.at = 11;
  const auto beyond = what_if(options);
  ASSERT_FALSE(beyond);
  EXPECT_EQ(beyond.error().find("--at: the session is 10."), 0u) << beyond.error();
}

}  // namespace
}  // namespace robot::app
