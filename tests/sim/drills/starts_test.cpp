#include "sim/drills/starts.h"

#include <gtest/gtest.h>

#include <cmath>
#include <set>

#include "sim/io/source.h"
#include "sim/match/hash.h"
#include "sim/match/snapshot.h"
#include "tests/sim/support/allocations.h"
#include "tests/sim/support/games.h"

namespace sim::drills {
namespace {

constexpr const char* kRanges = R"({"seconds": 20, "success": "our goal", "start": {
  "ball": {"x": [0, 1], "y": [-1, 1], "velocity_x": [-0.5, 0.5]},
  "robots": [{"side": "home", "player": 2, "x": [-2, -1], "y": [-1.5, 1.5], "heading": [-3, 3]},
             {"side": "away", "player": 1, "x": 2.5, "y": 0}]}})";

struct Prepared {
  explicit Prepared(const std::string& text) : drill(*parse_drill(text, "drill 'mine'")) {
    game = test::setup_of(drill.game);
    auto made = Starts::prepare(drill, game.params);
    EXPECT_TRUE(made) << made.error();
    starts.emplace(*made);
  }
  State draw(std::uint64_t seed) const { return starts->draw(game.params, {seed}); }

  Drill drill;
  io::PreparedGame game;
  std::optional<Starts> starts;
};

TEST(Starts, FillTheirRangesEvenly) {
  const Prepared prepared(kRanges);
  constexpr int kDraws = 4000;
  double ball_x = 0, heading = 0, low = 0;
  for (std::uint64_t seed = 0; seed < kDraws; ++seed) {
    const World world = prepared.draw(seed).world;
    const Body& robot = world.bodies[robot_of(Side::home, 2)];
    ASSERT_TRUE(world.ball.position.x >= 0 && world.ball.position.x < 1);
    ASSERT_TRUE(std::abs(world.ball.velocity.x) <= 0.5f && world.ball.velocity.y == 0);
    ASSERT_TRUE(robot.position.x >= -2 && robot.position.x < -1 && std::abs(robot.heading) <= 3);
    ASSERT_EQ(world.bodies[robot_of(Side::away, 1)].position, (Vec2{2.5f, 0}));
    ball_x += static_cast<double>(world.ball.position.x), heading += static_cast<double>(robot.heading);
    low += world.ball.position.x < 0.25f;
  }
  EXPECT_NEAR(ball_x / kDraws, 0.5, 5 * 0.289 / std::sqrt(kDraws));
  EXPECT_NEAR(heading / kDraws, 0, 5 * 6 * 0.289 / std::sqrt(kDraws));
  EXPECT_NEAR(low / kDraws, 0.25, 5 * 0.433 / std::sqrt(kDraws));
}

TEST(Starts, TheSameSeedIsTheSameStartAndOthersDiffer) {
  const Prepared prepared(kRanges);
  std::set<std::uint64_t> different;
  for (std::uint64_t seed = 0; seed < 100; ++seed) {
    EXPECT_EQ(hash_of(prepared.draw(seed)), hash_of(prepared.draw(seed)));
    different.insert(hash_of_game(prepared.draw(seed)));
  }
  EXPECT_EQ(different.size(), 100u);
}

TEST(Starts, OfShippedDrillsHaveRoomAndAreValid) {
  for (const std::string_view name : io::names_of("drills")) {
    const auto drill = load_drill(std::string(name));
    ASSERT_TRUE(drill) << drill.error();
    const io::PreparedGame game = test::setup_of(drill->game);
    const auto starts = Starts::prepare(*drill, game.params);
    ASSERT_TRUE(starts);
    for (std::uint64_t seed = 0; seed < 300; ++seed) {
      const State state = starts->draw(game.params, {seed});
      const World& world = state.world;
      ASSERT_TRUE(restore(snapshot_of(state)).state) << name;
      test::for_each_body(world, [&](int robot, const Body& body) {
        ASSERT_GE(distance(body.position, world.ball.position), 0.2f) << name << " seed " << seed;
        test::for_each_body(world, [&](int other, const Body& another) {
          ASSERT_TRUE(other == robot || distance(body.position, another.position) >= 0.4f) << name << " seed " << seed;
        });
      });
    }
  }
}

TEST(Starts, NobodyHasSeenAnUnknownBall) {
  const auto drill = load_drill("search_ball");
  ASSERT_TRUE(drill);
  const io::PreparedGame game = test::setup_of(drill->game);
  const State unknown = Starts::prepare(*drill, game.params)->draw(game.params, {1});
  EXPECT_EQ(unknown.robots[robot_of(Side::home, 2)].beliefs.ball.seen, kNever);
  const State known = Prepared(kRanges).draw(1);
  EXPECT_EQ(known.robots[robot_of(Side::home, 2)].beliefs.ball.seen, known.world.tick);
}

TEST(Starts, KeepPhaseAndSetPlay) {
  for (const auto& [name, set_play] :
       {std::pair{"kick_off", agent::Game::SetPlay::kick_off}, {"corner", agent::Game::SetPlay::corner_kick}}) {
    const auto drill = load_drill(name);
    ASSERT_TRUE(drill);
    const io::PreparedGame game = test::setup_of(drill->game);
    const State state = Starts::prepare(*drill, game.params)->draw(game.params, {1});
    EXPECT_EQ(state.book.set_play, set_play);
    EXPECT_EQ(state.book.kicking, Side::home);
  }
}

TEST(Starts, ADrawAllocatesNothing) {
  const Prepared prepared(kRanges);
  const std::size_t before = test::allocations();
  const State state = prepared.draw(3);
  EXPECT_EQ(test::allocations(), before);
  EXPECT_EQ(state.world.key.seed, 3u);
}

TEST(Starts, AnErrorNamesDrillAndPlace) {
  auto drill =
      parse_drill(R"({"seconds": 9, "success": "our goal", "start": {"ball": {"x": [0, 30], "y": 0}, "robots": []}})",
                  "drill 'far'");
  ASSERT_TRUE(drill);
  drill->name = "far";
  const auto starts = Starts::prepare(*drill, test::setup_of({}).params);
  ASSERT_FALSE(starts);
  EXPECT_EQ(starts.error(), "drill 'far': start: ball.x must be -20 .. 20, got 30");
}

}  // namespace
}  // namespace sim::drills
