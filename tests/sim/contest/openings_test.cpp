#include "sim/contest/openings.h"

#include <gtest/gtest.h>

#include <fstream>
#include <map>

#include "sim/io/matchup.h"
#include "sim/match/hash.h"
#include "tests/support/temporary_folder.h"

namespace sim::contest {
namespace {

const Params& params() {
  static const io::PreparedGame game = io::prepare({}).value();
  return game.params;
}

std::string situation(double ball_x) {
  return R"({"about": "a ball", "seed": 7, "ball": {"x": )" + std::to_string(ball_x) + R"(, "y": 0},
    "robots": [{"side": "home", "player": 2, "x": -1, "y": 0, "heading": 0}]})";
}

TEST(Openings, TakeTheSituationsOfAFolderEvenly) {
  const tests::TemporaryFolder folder;
  for (const int i : {0, 1, 2}) std::ofstream(folder.path() / ("s" + std::to_string(i) + ".json")) << situation(i);
  const auto openings = Openings::read(folder.path().string(), false, params());
  ASSERT_TRUE(openings) << openings.error();
  std::map<float, int> begun;
  for (std::uint64_t seed = 100; seed < 130; ++seed) ++begun[openings->begin(params(), seed).world.ball.position.x];
  EXPECT_EQ(begun, (std::map<float, int>{{0.f, 10}, {1.f, 10}, {2.f, 10}}));
}

TEST(Openings, GiveEachSeedItsOwnGameAndAlwaysTheSame) {
  const tests::TemporaryFolder folder;
  std::ofstream(folder.path() / "only.json") << situation(1);
  for (const std::string& from : {std::string(), folder.path().string()})
    for (const bool fuzz : {false, true}) {
      const auto openings = Openings::read(from, fuzz, params());
      ASSERT_TRUE(openings) << openings.error();
      EXPECT_EQ(hash_of(openings->begin(params(), 1)), hash_of(openings->begin(params(), 1)));
      EXPECT_NE(openings->begin(params(), 1).world.key.seed, openings->begin(params(), 2).world.key.seed);
    }
}

TEST(Openings, FuzzMovesTheBallALittle) {
  const tests::TemporaryFolder folder;
  std::ofstream(folder.path() / "only.json") << situation(1);
  const auto openings = Openings::read(folder.path().string(), true, params());
  ASSERT_TRUE(openings) << openings.error();
  const Vec2 one = openings->begin(params(), 1).world.ball.position;
  const Vec2 two = openings->begin(params(), 2).world.ball.position;
  EXPECT_NE(one, two);
  EXPECT_LT(length(one - two), 1);
}

TEST(Openings, GiveTheOtherSideTheMomentOfTheSameNumber) {
  const tests::TemporaryFolder folder;
  for (const int i : {1, 2, 3}) std::ofstream(folder.path() / ("s" + std::to_string(i) + ".json")) << situation(i);
  const auto openings = Openings::read(folder.path().string(), false, params());
  ASSERT_TRUE(openings) << openings.error();
  referee::Events events;
  for (std::uint64_t moment = 0; moment < 6; ++moment) {
    const State state = openings->begin(params(), {.seed = 1000, .moment = moment, .turned = true}, events);
    EXPECT_EQ(state.world.ball.position, (Vec2{-static_cast<float>(moment % 3 + 1), 0}));
    EXPECT_NE(state.world.bodies[robot_of(Side::away, 2)].doing, Body::Doing::removed);
    EXPECT_EQ(state.world.bodies[robot_of(Side::home, 2)].doing, Body::Doing::removed);
  }
}

TEST(Openings, RefuseAFolderWithoutSituations) {
  const tests::TemporaryFolder folder;
  const auto openings = Openings::read(folder.path().string(), false, params());
  ASSERT_FALSE(openings);
  EXPECT_EQ(openings.error(),
            "folder '" + folder.path().string() + "': expected situations, files that end in .json, there are none");
}

}  // namespace
}  // namespace sim::contest
