#include "sim/debug/coverage.h"

#include <gtest/gtest.h>

#include <cmath>

#include "sim/match/hash.h"
#include "tests/sim/debug/played.h"

namespace sim::debug {
namespace {

using test::setup_of;

const agent::Tree& tree_of_side(const SharedSetup& setup, Side side) {
  return tree_of(setup->params, side == Side::home ? 0 : kMaxPlayers)->tree();
}

/// A decision in play, found without any trace.
struct Seen {
  int robot;
  Tick tick;
  std::uint16_t leaf;
};

/// The decisions of one side in a game, its goals, and the ticks that it spent in each leaf.
struct Game {
  std::vector<Seen> decisions;
  std::vector<std::pair<Tick, int>> goals;  // tick, +1 or -1
  std::vector<std::int64_t> ticks;          // by leaf
  std::uint64_t hash = 0;
};

Game seen_by_hand(const SharedSetup& setup, Side side, std::uint64_t seed) {
  const Params& params = setup->params;
  const agent::Tree& tree = tree_of_side(setup, side);
  Game game;
  game.ticks.resize(tree.leaves.size());
  State state = sim::test::begun(params, seed);
  referee::Events events;
  while (!finished(state)) {
    const Tick now = state.world.tick;
    for_each_robot(state.world.players, [&](int robot) {
      if (side_of(robot) != side || !decides(state, robot)) return;
      const auto decision = decision_in(params, state, robot);
      ASSERT_TRUE(decision);
      if (!agent::plays(decision->game)) return;
      game.decisions.push_back({robot, now, leaf_of(tree, Thought(params, tree, *decision).view())});
    });
    step(params, state, events);
    for_each_robot(state.world.players, [&](int robot) {
      const std::uint16_t leaf = state.robots[robot].mind.leaf;
      if (side_of(robot) == side && leaf != agent::kNoLeaf && state.schedule.turn[robot] != kNever) ++game.ticks[leaf];
    });
    for (const referee::Event& event : events)
      if (event.kind == referee::Event::Kind::goal) game.goals.emplace_back(now, event.side == side ? 1 : -1);
  }
  game.hash = hash_of_game(state);
  return game;
}

TEST(Coverage, AgreesWithDecisionsThatAreMadeAgainByHand) {
  const SharedSetup setup = setup_of("baseline", "passing", 240);
  std::int64_t goals = 0;
  for (const Side side : {Side::home, Side::away})
    for (std::uint64_t seed = 1; seed <= 3; ++seed) {
      const Parts parts(tree_of_side(setup, side));
      const Game game = seen_by_hand(setup, side, seed);
      State state = sim::test::begun(setup->params, seed);
      const Coverage seen = watch_game(setup->params, state, side, parts);
      EXPECT_EQ(hash_of_game(state), game.hash) << "watching changes no game";
      goals += static_cast<std::int64_t>(game.goals.size());

      std::vector<Visits> expected(parts.all().size());
      for (const Seen& decision : game.decisions)
        for (const std::size_t part : parts.around(decision.leaf)) {
          ++expected[part].decisions;
          for (const auto& [tick, gain] : game.goals)
            if (tick >= decision.tick && tick - decision.tick < ticks(kOutlook)) expected[part].gain += gain;
        }
      for (std::uint16_t leaf = 0; leaf < game.ticks.size(); ++leaf)
        for (const std::size_t part : parts.around(leaf)) expected[part].ticks += game.ticks[leaf];
      for (std::size_t part = 0; part < expected.size(); ++part) {
        EXPECT_EQ(seen.parts[part].decisions, expected[part].decisions) << parts.all()[part].path;
        EXPECT_EQ(seen.parts[part].gain, expected[part].gain) << parts.all()[part].path;
        EXPECT_EQ(seen.parts[part].ticks, expected[part].ticks) << parts.all()[part].path;
      }
    }
  EXPECT_GT(goals, 0) << "choose games with goals";
}

TEST(Coverage, AWholeIsTheSumOfItsParts) {
  const SharedSetup setup = setup_of("baseline", "baseline", 120);
  const Parts parts(tree_of_side(setup, Side::home));
  State state = sim::test::begun(setup->params, 5);
  const Coverage seen = watch_game(setup->params, state, Side::home, parts);
  for (std::size_t whole = 0; whole < parts.all().size(); ++whole) {
    if (!parts.all()[whole].skill.empty()) continue;
    Visits sum;
    for (std::size_t part = whole + 1; part < parts.all().size() && parts.all()[part].depth > parts.all()[whole].depth;
         ++part)
      if (parts.all()[part].depth == parts.all()[whole].depth + 1) sum.add(seen.parts[part]);
    EXPECT_EQ(sum.decisions, seen.parts[whole].decisions) << parts.all()[whole].path;
    EXPECT_EQ(sum.ticks, seen.parts[whole].ticks) << parts.all()[whole].path;
    EXPECT_EQ(sum.gain, seen.parts[whole].gain) << parts.all()[whole].path;
    EXPECT_GE(sum.stays, seen.parts[whole].stays) << "who changes to another part of it stays in it";
  }
  const agent::Tree& tree = parts.tree();
  const Asked& first = seen.comparisons[tree.root];
  EXPECT_EQ(first.yes + first.no, seen.parts.front().decisions) << "every decision begins at the root";
  std::int64_t arrivals = 0;
  for (std::size_t i = 0; i < tree.nodes.size(); ++i) {
    if (tree.nodes[i].yes & agent::kLeafBit) arrivals += seen.comparisons[i].yes;
    if (tree.nodes[i].no & agent::kLeafBit) arrivals += seen.comparisons[i].no;
    EXPECT_LE(seen.comparisons[i].unknown, seen.comparisons[i].no) << "an unknown value answers no";
  }
  EXPECT_EQ(arrivals, seen.parts.front().decisions) << "every decision ends at a leaf";
}

TEST(Coverage, GamesAddUpInAnyOrder) {
  const SharedSetup setup = setup_of("baseline", "baseline", 60);
  const Parts parts(tree_of_side(setup, Side::home));
  std::vector<Coverage> games;
  for (std::uint64_t seed = 1; seed <= 3; ++seed) {
    State state = sim::test::begun(setup->params, seed);
    games.push_back(watch_game(setup->params, state, Side::home, parts));
  }
  Coverage forward, backward;
  for (const Coverage& game : games) forward.add(game);
  for (auto game = games.rbegin(); game != games.rend(); ++game) backward.add(*game);
  EXPECT_EQ(forward.games, 3);
  for (std::size_t i = 0; i < forward.parts.size(); ++i) {
    EXPECT_EQ(forward.parts[i].decisions, backward.parts[i].decisions);
    EXPECT_EQ(gain_of(forward.parts[i], 3).half_width, gain_of(backward.parts[i], 3).half_width);
  }
}

TEST(Coverage, APartOfATreeComesRightAfterTheOneInWhichItLies) {
  for (const char* name : {"baseline", "passing", "high_line"}) {
    const SharedSetup setup = setup_of(name, "baseline");
    const Parts parts(tree_of_side(setup, Side::home));
    std::vector<std::string> around;
    for (const Part& part : parts.all()) {
      ASSERT_LE(part.depth, static_cast<int>(around.size()));
      around.resize(static_cast<std::size_t>(part.depth));
      const std::string begin = (part.depth > 0 ? around.back() + "/" : "") + part.name;
      EXPECT_TRUE(part.path == begin || part.path.starts_with(begin + "/")) << part.path;
      around.push_back(part.path);
    }
    for (std::size_t i = 0; i < parts.all().size(); ++i) {
      const int depth = parts.all()[i].depth;
      int inside = 0;
      for (std::size_t next = i + 1; next < parts.all().size() && parts.all()[next].depth > depth; ++next)
        inside += parts.all()[next].depth == depth + 1;
      EXPECT_NE(inside, 1) << parts.all()[i].path;
      EXPECT_EQ(inside == 0, !parts.all()[i].skill.empty()) << parts.all()[i].path;
    }
    for (std::uint16_t leaf = 0; leaf < parts.tree().leaves.size(); ++leaf) {
      ASSERT_FALSE(parts.around(leaf).empty()) << "a leaf that no comparison reaches";
      EXPECT_EQ(parts.all()[parts.around(leaf).back()].path, parts.tree().leaf_words[leaf].path);
    }
  }
}

// Eleven games of 10 decisions, one of them with a gain of 11. The mean is 11/110. The residuals are 11 - 1 = 10 once and
// -1 ten times; the error is sqrt((100 + 10) * 11 / 10) / 110 = 0.1, and Student's t of ten degrees 2.228.
TEST(Coverage, TheIntervalOfAGainIsThatOfARatio) {
  Visits visits;
  visits.add({.decisions = 10, .gain = 11, .gain_squares = 121, .gain_decisions = 110, .decision_squares = 100});
  for (int game = 0; game < 10; ++game) visits.add({.decisions = 10, .decision_squares = 100});
  const MeanGain gain = gain_of(visits, 11);
  EXPECT_DOUBLE_EQ(gain.mean, 0.1);
  EXPECT_NEAR(gain.half_width, 0.2228, 0.003);
  EXPECT_TRUE(std::isinf(gain_of(visits, kFewGames - 1).half_width));
  EXPECT_TRUE(std::isinf(gain_of({}, 11).half_width));
}

}  // namespace
}  // namespace sim::debug
