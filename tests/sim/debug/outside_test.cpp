// Behaviours from outside in the debugger: their past comes again, from their saved memory or by playing it again.
#include <gtest/gtest.h>

#include <map>
#include <random>

#include "sim/contest/lineup.h"
#include "sim/debug/futures.h"
#include "sim/debug/session.h"
#include "sim/match/hash.h"
#include "tests/sim/debug/played.h"

namespace sim::debug {
namespace {

using test::kTeams;

const std::string kPython = std::string("pipe:") + FORESIGHT_PYTHON + " " + FORESIGHT_EXAMPLES + "/charge.py";

/// A behaviour from outside, the moments that are visited, and whether it saves its memory.
struct Case {
  std::string name;
  Tick length;
  int visits;
  bool saves;
};

class OutsideTest : public testing::TestWithParam<Case> {
 protected:
  OutsideTest() : setup_(test::setup_of(GetParam().name, "baseline", 90)) {}

  State begun() const { return sim::test::begun(setup_->params, 7); }

  SharedSetup setup_;
};

TEST_P(OutsideTest, AnyTickIsThatOfTheGameWithoutTheDebugger) {
  // the game itself
  contest::Cast cast(*setup_->lineup, 7);
  Params params = setup_->params;
  params.teams[0].behaviour = cast.params().teams[0].behaviour;
  State state = begun();
  referee::Events events;
  std::vector<std::uint64_t> expected{hash_of(state)};
  while (state.world.tick < GetParam().length) step(params, state, events), expected.push_back(hash_of(state));
  ASSERT_FALSE(cast.failed()) << cast.problem();

  Timeline timeline(setup_, begun());
  EXPECT_EQ(timeline.saves(), GetParam().saves);
  std::mt19937 random(1);
  for (int n = 0; n < GetParam().visits; ++n) {
    const auto tick = static_cast<Tick>(random() % expected.size());
    ASSERT_EQ(hash_of(timeline.at(tick)), expected[tick]) << tick;
  }
  const Timeline copy = timeline;
  Timeline copied = copy;
  EXPECT_EQ(hash_of(copied.at(GetParam().length)), expected.back()) << "a copy begins its own players";
  EXPECT_EQ(timeline.problem(), "");
}

TEST_P(OutsideTest, AnEditIsPlayedOnAndComesAgain) {
  const Tick edited = GetParam().length / 2, end = GetParam().length;
  Timeline timeline(setup_, begun());
  const std::uint64_t unedited = hash_of(timeline.at(end));
  State state = timeline.at(edited);
  state.world.ball.position = {1, 0.5f};
  timeline.change(state, setup_);
  const std::uint64_t changed = hash_of(timeline.at(end));
  EXPECT_NE(changed, unedited);
  timeline.at(edited - 20);
  EXPECT_EQ(hash_of(timeline.at(end)), changed);
  EXPECT_EQ(hash_of(timeline.at(edited)), hash_of(state));
}

TEST_P(OutsideTest, FuturesBeginWithItsMemory) {
  const Tick begin = GetParam().length / 2, length = GetParam().length - begin;
  Timeline timeline(setup_, begun());
  Moment moment{.setup = setup_, .state = timeline.at(begin)};
  moment.past = std::make_shared<const Timeline>(timeline);
  const Futures same = futures({{moment, moment}, {moment, moment}}, robot_of(Side::home, 2), length);
  EXPECT_EQ(same.different, 0);
  const std::vector<Vec2>& path = same.paths_without.front().ball;
  for (std::size_t i = 0; i < path.size(); ++i)
    EXPECT_EQ(path[i], timeline.at(begin + static_cast<Tick>(i) * FuturePath::kSpacing).world.ball.position) << i;
}

TEST_P(OutsideTest, OnlyATreeHasReasons) {
  Session session(setup_, begun(), kTeams);
  EXPECT_NE(session.note().find(GetParam().saves ? "save their memory" : "played again from its first tick"),
            std::string::npos);
  const auto error = [&](const std::string& line) {
    const auto text = session.run(line);
    return text ? "it was done: " + *text : text.error();
  };
  ASSERT_TRUE(session.run("goto 12"));
  const std::string no_tree = "14/2 plays '" + GetParam().name + "', which is no decision tree";
  for (const char* line : {"why", "whynot kick", "nodes", "leaves", "set threshold 1 2 m", "until skill changes",
                           "set argument aim goal of kick", "break ball_age < 1 s"})
    EXPECT_EQ(error(line), no_tree) << line;
  EXPECT_TRUE(session.run("why 5/2"));
  EXPECT_TRUE(session.run("set ball 1 0.5"));
  const auto text = session.run("futures 2 1");
  ASSERT_TRUE(text) << text.error();
  EXPECT_NE(text->find("2 pairs of futures of 1 s, 2 of them differ"), std::string::npos) << *text;
  EXPECT_TRUE(session.run("undo"));
}

INSTANTIATE_TEST_SUITE_P(Guests, OutsideTest,
                         testing::Values(Case{FORESIGHT_CHARGE, 1500, 100, true}, Case{kPython, 450, 4, false}),
                         [](const auto& info) { return info.param.saves ? "Library" : "Process"; });

TEST(Outside, ABehaviourThatFailsIsTold) {
  const std::string ends_soon = kPython + " | sed -u 300q";
  const SharedSetup setup = test::setup_of(ends_soon, "baseline", 90);
  Session session(setup, sim::test::begun(setup->params, 7), kTeams);
  EXPECT_TRUE(session.run("step 5 ticks"));
  const auto done = session.run("goto 80");
  ASSERT_FALSE(done);
  EXPECT_NE(done.error().find(": player "), std::string::npos) << done.error();
}

TEST(Outside, ASideThatMixesItWithATreeIsRefused) {
  contest::LineupChoice choice;
  choice.game.strategies[0] = FORESIGHT_CHARGE;
  choice.rest[0] = "baseline", choice.changed = 2;
  const auto setup = prepare(choice);
  ASSERT_FALSE(setup);
  EXPECT_EQ(setup.error(), "the debugger needs a whole side for a behaviour from outside");
}

}  // namespace
}  // namespace sim::debug
