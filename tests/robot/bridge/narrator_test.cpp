// A simulated game as memory objects: every object of every robot, at the times of images and bodies.
#include "robot/bridge/narrator.h"

#include <gtest/gtest.h>

#include <cmath>
#include <map>
#include <memory>
#include <string>
#include <vector>

#include "robot/bridge/simulated_game.h"
#include "sim/io/matchup.h"
#include "sim/match/step.h"

namespace robot::bridge {
namespace {

class StoppedClock final : public Clock {
 public:
  std::uint64_t now_ns() const override { return 1'000'000'000'000; }
};
const StoppedClock kClock;

constexpr std::uint64_t kEpochNs = 1'340'000'000'000'000'000;

/// A game at its kick-off, and its narrator.
struct Narrated {
  sim::io::PreparedGame prepared;
  std::unique_ptr<SimulatedGame> game;
  std::unique_ptr<Narrator> narrator;
  memory::Channels channels;
  Timeline timeline{.epoch_ns = kEpochNs};
  sim::referee::Events events;

  explicit Narrated(sim::io::Matchup matchup = {}) {
    auto made = sim::io::prepare(matchup);
    if (!made) throw std::runtime_error(made.error());
    prepared = std::move(*made);
    game = std::make_unique<SimulatedGame>(prepared.params, GameNames{.rules = matchup.rules},
                                           sim::begin(prepared.params, {7}, events));
    narrator = std::make_unique<Narrator>(*game, 0, kClock);
    if (const auto listed = narrator->list(channels); !listed) throw std::runtime_error(listed.error());
    narrator->write(*game, timeline);
    narrator->write_status(*game, {}, timeline);
  }

  void tick() {
    game->tick(events);
    narrator->write(*game, timeline);
    narrator->write_status(*game, {}, timeline);
  }

  template <class Message>
  Message newest(const std::string& topic) const {
    Message message;
    const auto version = channels.find(topic)->newest();
    EXPECT_TRUE(version) << topic;
    if (version) message.ParseFromArray(version->bytes().data(), static_cast<int>(version->bytes().size()));
    return message;
  }
};

TEST(Narrator, WritesEveryObjectOfEveryRobotTheTruthAndTheStateOfTheSimulation) {
  Narrated narrated({.pace = sim::Pace::every_tick});
  for (int tick = 0; tick < 30 * 60; ++tick) narrated.tick();
  const auto all = narrated.channels.all();
  EXPECT_EQ(all.size(), 8u * 11u + 2u);  // four a side with eleven objects each
  for (const auto& channel : all) EXPECT_TRUE(channel->newest()) << channel->info().topic;
}

TEST(Narrator, WritesTheSameBytesForTheSameGame) {
  Narrated first, second;
  for (int tick = 0; tick < 600; ++tick) first.tick(), second.tick();
  const auto a = first.channels.all(), b = second.channels.all();
  ASSERT_EQ(a.size(), b.size());
  for (std::size_t i = 0; i < a.size(); ++i) {
    if (!a[i]->newest()) continue;
    EXPECT_EQ(a[i]->newest()->bytes(), b[i]->newest()->bytes()) << a[i]->info().topic;
    EXPECT_EQ(a[i]->newest()->capture_ns(), b[i]->newest()->capture_ns()) << a[i]->info().topic;
  }
}

TEST(Narrator, GivesBeliefsTheTimeOfTheirImageAndTheTruthThatOfTheTicksEnd) {
  Narrated narrated({.pace = sim::Pace::every_tick});
  for (int tick = 0; tick < 10; ++tick) narrated.tick();
  const auto captured = [&](const std::string& topic) { return narrated.channels.find(topic)->newest()->capture_ns(); };
  EXPECT_EQ(captured("/truth/world"), narrated.timeline.at(10));
  EXPECT_EQ(captured("/14/2/motion_status"), narrated.timeline.at(10));
  EXPECT_EQ(captured("/14/2/odometry"), narrated.timeline.at(10));
  EXPECT_EQ(captured("/14/2/pose"), narrated.timeline.at(9));
  EXPECT_EQ(captured("/14/2/motion_command"), narrated.timeline.at(9));
}

TEST(Narrator, AnImageShowsTheBallThatTheBeliefComesFrom) {
  Narrated narrated({.models = {"perfect", "match"}, .pace = sim::Pace::every_tick});
  int seen = 0;
  for (int tick = 0; tick < 30 * 60; ++tick) {
    narrated.tick();
    for (const std::string robot : {"/14/2/", "/5/2/"}) {
      if (!narrated.channels.find(robot + "ball")->newest()) continue;
      const auto ball = narrated.newest<foresight::Ball>(robot + "ball");
      if (!ball.visible()) continue;
      const auto vision = narrated.newest<foresight::Vision>(robot + "vision");
      ASSERT_TRUE(vision.has_ball()) << robot << tick;
      ++seen;
      if (robot != "/14/2/") continue;  // noise and a filter
      ASSERT_EQ(vision.ball().detection().x(), ball.x());
      ASSERT_EQ(vision.ball().detection().y(), ball.y());
    }
  }
  EXPECT_GT(seen, 100);
}

TEST(Narrator, ThePerceptLiesInTheCamerasImageWhereItsProjectionIs) {
  Narrated narrated({.models = {"perfect", "perfect"}, .pace = sim::Pace::every_tick});
  int seen = 0;
  for (int tick = 0; tick < 30 * 60; ++tick) {
    narrated.tick();
    const auto vision = narrated.newest<foresight::Vision>("/14/2/vision");
    if (!vision.has_ball()) continue;
    const auto camera = narrated.newest<foresight::CameraMatrix>("/14/2/camera_top_matrix");
    const foresight::Detection& ball = vision.ball().detection();
    const float point[3] = {ball.x() - camera.x(), ball.y() - camera.y(),
                            narrated.prepared.params.teams[0].models.ball.radius - camera.z()};
    float seen_from[3] = {};  // [m, camera]
    for (int axis = 0; axis < 3; ++axis)
      for (int i = 0; i < 3; ++i) seen_from[axis] += camera.rotation(3 * i + axis) * point[i];
    if (seen_from[2] < 0.05f) continue;  // below the robot
    ++seen;
    EXPECT_NEAR(ball.image_x(), camera.centre_x() + camera.focal_x() * seen_from[0] / seen_from[2], 0.5);
    EXPECT_NEAR(ball.image_y(), camera.centre_y() + camera.focal_y() * seen_from[1] / seen_from[2], 0.5);
    EXPECT_NEAR(std::tan(ball.angle_x()), seen_from[0] / seen_from[2], 1e-3);
    EXPECT_NEAR(std::tan(ball.angle_y()), seen_from[1] / seen_from[2], 1e-3);
  }
  EXPECT_GT(seen, 100);
}

TEST(Narrator, TheOdometryDriftsAsTheModelSays) {
  Narrated narrated({.models = {"perfect",
                                "perfect,effects.odometry_drift=true,localisation.bias=0,"
                                "localisation.rotation_noise=0,localisation.rotation_per_metre=0,"
                                "localisation.translation_noise=0.2"},
                     .pace = sim::Pace::every_tick});
  double way = 0, squares = 0;
  sim::World before = narrated.game->state().world;
  for (int tick = 0; tick < 30 * 120; ++tick) {
    sim::Pose2 believed[2];
    const int robots[2] = {1, sim::robot_of(sim::Side::away, 2)};
    for (int i = 0; i < 2; ++i) believed[i] = narrated.game->odometry(robots[i]);
    narrated.tick();
    const sim::World& now = narrated.game->state().world;
    for (int i = 0; i < 2; ++i) {
      const sim::Body &from = before.bodies[robots[i]], &to = now.bodies[robots[i]];
      const sim::Vec2 moved = sim::turned_back(to.position - from.position, from.facing);
      if (sim::length(moved) > 0.1f) continue;
      const sim::Vec2 step = sim::turned_back(narrated.game->odometry(robots[i]).position - believed[i].position,
                                              sim::direction(believed[i].heading));
      const sim::Vec2 error = step - moved;
      if (i == 0) {
        EXPECT_LT(sim::length(error), 1e-5f) << "without the effect it is the true way";
      } else {
        way += sim::length(moved), squares += sim::squared_length(error);
      }
    }
    before = now;
  }
  ASSERT_GT(way, 5);
  EXPECT_NEAR(std::sqrt(squares / 2 / way), 0.2, 0.02);
}

TEST(Narrator, TakesTheBallsDecelerationFromTheRobotsOwnTeam) {
  Narrated narrated({.models = {"perfect", "perfect,ball.deceleration=0.8"}, .pace = sim::Pace::every_tick});
  for (int tick = 0; tick < 30 * 30; ++tick) {
    narrated.tick();
    for (const auto& [topic, expected] :
         std::map<std::string, float>{{"/14/2/ball", narrated.prepared.params.teams[0].models.ball.deceleration},
                                      {"/5/2/ball", narrated.prepared.params.teams[1].models.ball.deceleration}}) {
      if (!narrated.channels.find(topic)->newest()) continue;
      const auto ball = narrated.newest<foresight::Ball>(topic);
      const float slowing = std::hypot(ball.acceleration_x(), ball.acceleration_y());
      if (slowing > 0) {
        EXPECT_NEAR(slowing, expected, 1e-5f) << topic << ", tick " << tick;
      }
    }
  }
  EXPECT_NE(narrated.prepared.params.teams[0].models.ball.deceleration,
            narrated.prepared.params.teams[1].models.ball.deceleration);
}

TEST(Narrator, ReportsRulesTeamsAndScoreInTheStateOfTheSimulation) {
  Narrated narrated({.rules = "spl2025", .strategies = {"baseline", "kick_now"}});
  for (int tick = 0; tick < 5; ++tick) narrated.tick();
  const auto state = narrated.newest<foresight::Simulation>("/sim/state");
  EXPECT_EQ(state.rules(), "spl2025");
  EXPECT_EQ(state.home().strategy(), "baseline");
  EXPECT_EQ(state.away().strategy(), "kick_now");
  EXPECT_EQ(state.tick(), 5u);
  EXPECT_EQ(state.speed(), 1);
  EXPECT_FALSE(state.paused());
  EXPECT_FLOAT_EQ(state.field().length(), narrated.prepared.params.rules.field.length);
}

TEST(Narrator, StartsAnewAfterAnotherGameBegins) {
  Narrated narrated;
  for (int tick = 0; tick < 100; ++tick) narrated.tick();
  const auto before = narrated.channels.find("/14/2/game")->newest()->sequence();
  narrated.game->begin(sim::begin(narrated.prepared.params, {8}, narrated.events));
  narrated.narrator->forget();
  narrated.narrator->write(*narrated.game, narrated.timeline);
  EXPECT_GT(narrated.channels.find("/14/2/game")->newest()->sequence(), before);
  EXPECT_EQ(narrated.game->odometry(1).position.x, 0);
}

}  // namespace
}  // namespace robot::bridge
