// The agent on a robot decides from memory as the simulated robot with the same beliefs does.
#include "robot/agent/agent.h"

#include <gtest/gtest.h>

#include <fstream>
#include <memory>
#include <string>

#include "robot/agent/agent_thread.h"
#include "robot/bridge/narrator.h"
#include "sim/io/matchup.h"
#include "sim/match/step.h"
#include "tests/support/eventually.h"
#include "tests/support/temporary_folder.h"

namespace robot::agent {
namespace {

class GivenClock final : public Clock {
 public:
  std::uint64_t now_ns() const override { return 1'340'000'000'000'000'000; }
};

/// A simulated game whose objects are in memory.
struct Playing {
  sim::io::PreparedGame prepared;
  GivenClock clock;
  sim::referee::Events events;
  std::unique_ptr<bridge::SimulatedGame> game;
  std::unique_ptr<bridge::Narrator> narrator;
  memory::Channels channels;
  bridge::Timeline timeline{.epoch_ns = 1'340'000'000'000'000'000};

  Playing() {
    auto made = sim::io::prepare({.rules = "spl2025", .models = {"match", "match"}, .pace = sim::Pace::every_tick});
    if (!made) throw std::runtime_error(made.error());
    prepared = std::move(*made);
    game = std::make_unique<bridge::SimulatedGame>(prepared.params, bridge::GameNames{.rules = "spl2025"},
                                                   sim::begin(prepared.params, {3}, events));
    narrator = std::make_unique<bridge::Narrator>(*game, 0, clock);
    if (const auto listed = narrator->list(channels); !listed) throw std::runtime_error(listed.error());
    narrator->write(*game, timeline);
  }

  void tick() {
    game->tick(events);
    narrator->write(*game, timeline);
  }

  bridge::Recollection recollection(const std::string& robot = "14/2") const {
    return bridge::recollect(channels, robot, timeline.at(game->state().world.tick));
  }
};

Agent agent_of(const AgentChoice& choice = {}) {
  auto agent = Agent::load(choice);
  if (!agent) throw std::runtime_error(agent.error());
  return std::move(*agent);
}

TEST(Agent, DecidesFromMemoryAsTheSimulatedRobotWithTheSameBeliefs) {
  Playing playing;
  Agent agent = agent_of();
  int decided = 0, equal = 0;
  for (int tick = 0; tick < 30 * 180; ++tick) {
    playing.tick();
    if (playing.game->state().world.bodies[1].doing == sim::Body::Doing::removed) continue;
    const Agent::Decision decision = agent.decide(playing.recollection());
    const sim::agent::Trace* simulated = playing.game->decision(1);
    if (!decision.trace || !simulated) continue;
    ++decided;
    if (decision.trace->skill() == simulated->skill) ++equal;
  }
  EXPECT_GT(decided, 30 * 90);
  // beliefs pass through messages without a robot's role history, so a few decisions at changes of roles differ
  EXPECT_GT(equal, 0.9 * decided);
}

TEST(Agent, AKickSaysWhereTheBallIs) {
  Playing playing;
  Agent agent = agent_of();
  int kicks = 0;
  for (int tick = 0; tick < 30 * 180; ++tick) {
    playing.tick();
    const bridge::Recollection recollection = playing.recollection();
    const pb::MotionCommand command = agent.decide(recollection).command;
    if (!command.has_kick()) continue;
    ++kicks;
    EXPECT_NEAR(command.kick().ball_x(), recollection.ball->value.x(), 0.05);
    EXPECT_NEAR(command.kick().ball_y(), recollection.ball->value.y(), 0.05);
  }
  EXPECT_GT(kicks, 0);
}

TEST(Agent, GivesTheSameCommandsForTheSameMemory) {
  Playing playing;
  Agent first = agent_of(), second = agent_of();
  for (int tick = 0; tick < 900; ++tick) {
    playing.tick();
    EXPECT_EQ(first.decide(playing.recollection()).command.SerializeAsString(),
              second.decide(playing.recollection()).command.SerializeAsString());
  }
}

TEST(Agent, StandsAndNamesTheReasonWithoutAPose) {
  Playing playing;
  playing.tick();
  bridge::Recollection recollection = playing.recollection();
  recollection.pose.reset();
  const Agent::Decision decision = agent_of().decide(recollection);
  EXPECT_EQ(decision.command.posture(), pb::MotionCommand::POSTURE_STAND);
  EXPECT_FALSE(decision.trace);
  EXPECT_EQ(decision.problem, "the robot does not know where it is: there is no object pose yet");
}

TEST(Agent, StandsWithAnOldPose) {
  Playing playing;
  playing.tick();
  bridge::Recollection recollection = playing.recollection();
  recollection.now_ns += 5 * kSecond;
  EXPECT_EQ(agent_of().decide(recollection).problem, "the robot does not know where it is: its pose is 5 s old");
}

TEST(Agent, PlaysALearnedPolicyByTheNameOfItsFile) {
  const tests::TemporaryFolder folder;
  const std::string path = (folder.path() / "learned.json").string();
  std::ofstream(path)
      << R"({"name": "learned", "based_on": "baseline", "menu": [{"do": "look_round"}, {"use": "chaser"}],
    "inputs": ["ball_known"], "net": {"layers": [{"weights": [[0], [1]], "bias": [0.5, 0]}]}})";
  Playing playing;
  Agent agent = agent_of({.behaviour = path, .strategies = {}});
  int looks = 0, others = 0;
  for (int tick = 0; tick < 30 * 90; ++tick) {
    playing.tick();
    const Agent::Decision decision = agent.decide(playing.recollection());
    if (!decision.trace) continue;
    EXPECT_EQ(decision.trace->strategy(), "learned");
    (decision.trace->skill() == "look_round" ? looks : others) += 1;
  }
  EXPECT_GT(others, 0);
  EXPECT_GT(looks + others, 30 * 45);
}

TEST(Agent, NamesABehaviourThatDoesNotExist) {
  const auto agent = Agent::load({.behaviour = "nonsense"});
  ASSERT_FALSE(agent);
  EXPECT_NE(agent.error().find("nonsense"), std::string::npos) << agent.error();
}

TEST(AgentThread, WritesCommandsAndDecisionsWithoutBeingAsked) {
  const SessionClock clock;
  const auto memory = std::make_shared<memory::Memory>("14/2", clock);
  memory::Channels channels;
  ASSERT_TRUE(list(memory, channels));
  pb::GameState game;
  game.set_state(pb::GameState::STATE_PLAYING);
  game.set_own_team(14), game.set_own_player(2), game.set_players_per_team(5);
  memory->game.write(game, clock.now_ns());
  AgentThread agent(agent_of(), *memory, channels, "14/2", clock);
  ASSERT_TRUE(agent.start());

  // it stands until it knows its pose
  ASSERT_TRUE(tests::eventually([&] { return memory->motion_command.read() != nullptr; }));
  EXPECT_EQ(memory->motion_command.read()->value().posture(), pb::MotionCommand::POSTURE_STAND);
  EXPECT_FALSE(memory->decision.read());
  ASSERT_TRUE(tests::eventually([&] {
    memory->pose.write(pb::Pose(), clock.now_ns());
    return memory->decision.read() != nullptr;
  }));
}

}  // namespace
}  // namespace robot::agent
