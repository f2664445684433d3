#include "robot/app/services/game_service.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>
#include <vector>

#include "robot/app/build_id.h"
#include "robot/app/services/recording_service.h"
#include "robot/memory/memory.h"
#include "tests/support/temporary_folder.h"

namespace robot::app {
namespace {

using foresight::GameState;

struct Game : ::testing::Test {
  Game() {
    EXPECT_TRUE(list(memory, channels));
    add_recording_service(recorder, store, parameters, services);
  }

  /// Writes the game state like the GameController.
  void tell(GameState::State state, std::uint32_t half) {
    GameState game;
    game.set_source(GameState::SOURCE_GAME_CONTROLLER);
    game.set_received_ns(clock.now_ns());
    game.set_state(state);
    game.set_half(half);
    game.set_own_team(14);
    game.set_own_player(3);
    game.mutable_opponent()->set_number(5);
    memory->game.write(game, clock.now_ns());
  }

  /// Writes the game state, and lets the service follow it.
  void hear(GameState::State state, std::uint32_t half = 1) {
    tell(state, half);
    service().follow();
  }

  GameOptions options() const { return {.link = {.team = 14, .player = 3}, .field = "A"}; }

  GameService& service() {
    if (!service_) service_.emplace(options(), *memory, clock, recorder, parameters);
    return *service_;
  }

  bool recording() const { return recorder.status().state == logging::RecordingStatus::State::recording; }

  const tests::TemporaryFolder folder;
  ManualClock clock{1'700'000'000 * kSecond};
  std::shared_ptr<memory::Memory> memory = std::make_shared<memory::Memory>("14/3", clock);
  memory::Channels channels;
  logging::LoggingBoard board;
  logging::SessionStore store{folder.path(), 4'000'000'000};
  logging::Recorder recorder{channels, board, store, clock, {.info = {.robot = "14/3", .team = 14, .player = 3}}};
  net::Parameters parameters;
  net::Services services;
  std::optional<GameService> service_;
};

TEST_F(Game, IsRecordedFromReadyToFinished) {
  hear(GameState::STATE_INITIAL);
  EXPECT_FALSE(recording());
  hear(GameState::STATE_READY);
  EXPECT_TRUE(recording());
  EXPECT_TRUE(parameters.flag("recording"));
  hear(GameState::STATE_PLAYING);
  hear(GameState::STATE_FINISHED);
  EXPECT_FALSE(recording());
  EXPECT_FALSE(parameters.flag("recording"));
  ASSERT_EQ(store.list().size(), 1u);
  EXPECT_EQ(store.list()[0].info.name, "A_vs-5_half-1_14-3_" + std::string(kBuildId));
  EXPECT_EQ(store.list()[0].info.profile, "game");
  EXPECT_EQ(store.list()[0].state, logging::SessionState::complete);
}

TEST_F(Game, AHalfBeginsWithReadyAlsoIfTheRobotWaitedLong) {
  hear(GameState::STATE_INITIAL);
  clock.set(clock.now_ns() + 180 * kSecond);
  const std::uint64_t ready_ns = clock.now_ns();
  hear(GameState::STATE_READY);
  clock.set(clock.now_ns() + 45 * kSecond);
  hear(GameState::STATE_PLAYING);
  hear(GameState::STATE_FINISHED);
  ASSERT_EQ(store.list().size(), 1u);
  EXPECT_EQ(store.list()[0].info.start_ns, ready_ns);
  EXPECT_EQ(store.list()[0].start_ns, ready_ns);
}

TEST_F(Game, AValueFromBeforeAHalfDoesNotMoveItsBeginningEvenIfItIsWrittenAgain) {
  const std::uint64_t early_ns = clock.now_ns();
  memory->pose.write({}, early_ns);
  memory->ball.write({}, early_ns);
  clock.set(clock.now_ns() + 180 * kSecond);
  const std::uint64_t ready_ns = clock.now_ns();
  hear(GameState::STATE_READY);
  memory->pose.write({}, early_ns);  // with its old capture time
  clock.set(clock.now_ns() + 60 * kSecond);
  memory->pose.write({}, clock.now_ns());
  hear(GameState::STATE_FINISHED);
  ASSERT_EQ(store.list().size(), 1u);
  EXPECT_EQ(store.list()[0].start_ns, ready_ns);
  EXPECT_EQ(store.list()[0].end_ns, ready_ns + 60 * kSecond);
}

TEST_F(Game, ARobotThatStartsLateOrAgainBeginsItsPartThen) {
  const std::uint64_t kick_off_ns = clock.now_ns();
  for (const std::uint64_t minutes : {0, 3, 5}) {
    clock.set(kick_off_ns + minutes * 60 * kSecond);
    net::Parameters of_program;
    net::Services calls;
    add_recording_service(recorder, store, of_program, calls);
    GameService program(options(), *memory, clock, recorder, of_program);
    tell(GameState::STATE_PLAYING, 1);
    program.follow();
    ASSERT_TRUE(recorder.stop());  // as a program that ends
  }
  std::vector<std::uint64_t> begins;
  for (const logging::Session& session : store.list()) {
    EXPECT_EQ(session.info.name, "A_vs-5_half-1_14-3_" + std::string(kBuildId)) << "the half that it belongs to";
    begins.push_back((session.start_ns - kick_off_ns) / (60 * kSecond));
  }
  std::ranges::sort(begins);
  EXPECT_EQ(begins, (std::vector<std::uint64_t>{0, 3, 5}));
}

TEST_F(Game, EachHalfIsItsOwnSession) {
  hear(GameState::STATE_READY, 1);
  hear(GameState::STATE_READY, 2);  // FINISHED was lost
  hear(GameState::STATE_FINISHED, 2);
  EXPECT_EQ(store.list().size(), 2u);
}

TEST_F(Game, AFullDiskDelaysTheRecordingAndDoesNotPreventIt) {
  std::filesystem::remove(folder.path());
  std::filesystem::create_symlink(folder.path().filename(), folder.path());  // no session can be made
  hear(GameState::STATE_READY);
  EXPECT_EQ(recorder.status().state, logging::RecordingStatus::State::disk_full);
  EXPECT_TRUE(parameters.flag("recording"));
  std::filesystem::remove(folder.path());
  recorder.tend();
  EXPECT_TRUE(recording());
  hear(GameState::STATE_FINISHED);
  EXPECT_FALSE(recording());
  EXPECT_EQ(store.list().size(), 1u);
}

TEST_F(Game, ASessionWhoseFilesWereDeletedIsEndedAllTheSame) {
  hear(GameState::STATE_READY);
  std::filesystem::remove_all(folder.path());
  recorder.tend();
  EXPECT_TRUE(recording());
  hear(GameState::STATE_FINISHED);
  EXPECT_EQ(recorder.status().state, logging::RecordingStatus::State::off);
  ASSERT_EQ(store.list().size(), 1u);
  EXPECT_EQ(store.list()[0].state, logging::SessionState::complete);
}

TEST_F(Game, AFieldWhoseNameCannotBeUsedPreventsNoRecording) {
  service_.emplace(GameOptions{.link = {.team = 14, .player = 3}, .field = std::string(5'000, 'A')}, *memory, clock,
                   recorder, parameters);
  hear(GameState::STATE_READY);
  EXPECT_TRUE(recording());
  EXPECT_EQ(store.list().at(0).info.name, "");
}

TEST_F(Game, ASessionThatAClientBeganIsNotTouched) {
  const std::string id = *recorder.start("mine", "game");
  hear(GameState::STATE_READY);
  hear(GameState::STATE_FINISHED);
  EXPECT_TRUE(recording());
  EXPECT_EQ(recorder.status().session, id);
  EXPECT_EQ(store.list().size(), 1u);
}

TEST_F(Game, ASessionThatAClientEndedIsNotEndedAgain) {
  hear(GameState::STATE_READY);
  ASSERT_TRUE(recorder.stop());
  const std::string id = *recorder.start("mine", "game");
  hear(GameState::STATE_FINISHED);
  EXPECT_TRUE(recording());
  EXPECT_EQ(recorder.status().session, id);
}

TEST_F(Game, ItsRecordingContainsTheObjectsOfTheParameter) {
  EXPECT_EQ(parameters.set("recording_objects", std::string("ball, gme")).error(),
            "no object 'gme'; did you mean 'game'?");
  ASSERT_TRUE(parameters.set("recording_objects", std::string("ball, game")));
  hear(GameState::STATE_PLAYING);
  hear(GameState::STATE_FINISHED);
  const auto sessions = store.list();
  ASSERT_EQ(sessions.size(), 1u);
  EXPECT_FALSE(sessions[0].streams.empty());
  for (const logging::StreamFile& stream : sessions[0].streams)
    EXPECT_TRUE(stream.topic == "/14/3/ball" || stream.topic == "/14/3/game") << stream.topic;
}

TEST_F(Game, ARequestForARecordingNamesItsObjects) {
  const auto start = [&](const char* request) {
    return services.call(1, request, {.loopback = true, .may_control = true});
  };
  EXPECT_EQ(start(R"({"only": ["bal"]})"),
            R"({"error":"start_recording: no object 'bal'; did you mean 'ball'?","ok":false})");
  EXPECT_NE(start(R"({"only": 7})").find("'only' must be a list of names of objects"), std::string::npos);
  EXPECT_FALSE(recording());
  EXPECT_NE(start(R"({"only": ["ball"]})").find(R"("ok":true)"), std::string::npos);
  memory->ball.write({}, clock.now_ns());
  memory->pose.write({}, clock.now_ns());
  ASSERT_TRUE(recorder.stop());
  const auto sessions = store.list();
  ASSERT_EQ(sessions.size(), 1u);
  ASSERT_EQ(sessions[0].streams.size(), 1u);
  EXPECT_EQ(sessions[0].streams[0].topic, "/14/3/ball");
}

TEST_F(Game, WithPracticeNoGameIsInMatchModeUntilTheParameterSaysSo) {
  service_.emplace(GameOptions{.link = {.team = 14, .player = 3}, .practice = true}, *memory, clock, recorder,
                   parameters);
  hear(GameState::STATE_PLAYING);
  EXPECT_TRUE(service().status().in_progress);
  EXPECT_TRUE(service().status().practice);
  EXPECT_FALSE(service().status().match_mode);
  ASSERT_TRUE(parameters.set("match_mode", true));
  EXPECT_FALSE(service().status().practice);
  EXPECT_TRUE(service().status().match_mode);
}

TEST_F(Game, MatchModeLastsAsLongUnlessItsParameterIsOff) {
  hear(GameState::STATE_SET);
  EXPECT_TRUE(service().status().match_mode);
  EXPECT_FALSE(service().status().practice);
  ASSERT_TRUE(parameters.set("match_mode", false));
  EXPECT_FALSE(service().status().match_mode);
  EXPECT_TRUE(service().status().practice);
  EXPECT_TRUE(service().status().in_progress);
  ASSERT_TRUE(parameters.set("match_mode", true));
  hear(GameState::STATE_FINISHED);
  EXPECT_FALSE(service().status().match_mode);
}

TEST_F(Game, AnUnreadableFormatIsRecordedInMatchMode) {
  GameState game;
  game.set_source(GameState::SOURCE_GAME_CONTROLLER);
  game.set_received_ns(clock.now_ns());
  game.set_unreadable(true);
  game.set_packet_version(21);
  memory->game.write(game, clock.now_ns());
  service().follow();
  EXPECT_TRUE(recording());
  EXPECT_TRUE(service().status().match_mode);
  EXPECT_EQ(store.list()[0].info.name, "A_format-21_14-3_" + std::string(kBuildId));
}

TEST_F(Game, FollowsTheGameThatTheTeamsOwnCodeWrites) {
  GameState game;
  game.set_state(GameState::STATE_READY);
  game.set_half(2);
  memory->game.write(game, clock.now_ns());
  service().follow();
  EXPECT_TRUE(recording());
  EXPECT_EQ(store.list()[0].info.name, "A_half-2_14-3_" + std::string(kBuildId));
}

TEST_F(Game, StatusSaysWhetherAMatchIsInProgress) {
  EXPECT_EQ(service().status().state, "");
  EXPECT_FALSE(service().status().in_progress);
  hear(GameState::STATE_PLAYING);
  EXPECT_EQ(service().status().state, "playing");
  EXPECT_TRUE(service().status().in_progress);
  hear(GameState::STATE_FINISHED);
  EXPECT_EQ(service().status().state, "finished");
  EXPECT_FALSE(service().status().in_progress);
}

}  // namespace
}  // namespace robot::app
