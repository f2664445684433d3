#include "sim/debug/stop.h"

#include <gtest/gtest.h>

#include <vector>

#include "tests/sim/debug/played.h"

namespace sim::debug {
namespace {

using test::kTeams;
using test::setup_of;
using test::timeline_of;

Stop parsed(std::string_view text, int focus = 1) {
  auto stop = parse_stop(text, 4, kTeams, focus);
  EXPECT_TRUE(stop) << stop.error();
  return stop ? *stop : Stop{{{Term{}}}};
}

std::string error_of(std::string_view text) {
  const auto stop = parse_stop(text, 4, kTeams, 1);
  return stop ? "" : stop.error();
}

/// Returns all ticks at which the condition becomes true, from the beginning.
std::vector<Tick> all_stops(Timeline& timeline, const Stop& stop) {
  std::vector<Tick> all;
  for (auto tick = next_stop(timeline, stop, timeline.first()); tick; tick = next_stop(timeline, stop, *tick))
    all.push_back(*tick);
  return all;
}

TEST(Stop, BackFindsTheSameMomentsAsForward) {
  Timeline timeline = timeline_of(setup_of("baseline", "passing", 60), 3);
  for (const char* text : {"our touch", "ball_x > 1 m", "14/3 skill changes and ball_x > 0 m", "5/2 ball_error > 0.5 m",
                           "not 14/2 ball_known or their shot"}) {
    const Stop stop = parsed(text);
    const std::vector<Tick> forward = all_stops(timeline, stop);
    EXPECT_FALSE(forward.empty()) << text;
    Tick now = timeline.played() + 1;
    for (std::size_t i = forward.size(); i-- > 0;) {
      const auto tick = previous_stop(timeline, stop, now);
      ASSERT_TRUE(tick) << text;
      EXPECT_EQ(*tick, forward[i]) << text;
      now = *tick;
      if (i + 4 < forward.size()) break;  // the last ones are enough
    }
  }
}

TEST(Stop, ItsTextMeansTheSameForEveryFocus) {
  Timeline timeline = timeline_of(setup_of("baseline", "passing", 60), 3);
  for (const char* text :
       {"skill changes", "not ball_known and our touch or 5/2 falls", "not home/3 ball_error > 0.5 m"}) {
    const Stop stop = parsed(text, 2), again = parsed(text_of(stop), 7);
    EXPECT_EQ(text_of(again), text_of(stop));
    EXPECT_EQ(all_stops(timeline, again), all_stops(timeline, stop)) << text_of(stop);
  }
  EXPECT_EQ(text_of(parsed("not ball_known and our touch", 2)), "not 14/3 ball_known and our touch");
}

TEST(Stop, StopsAtTheFirstStateInWhichAFactAboutTheGameHolds) {
  const SharedSetup setup = setup_of("baseline", "baseline", 60);
  Timeline timeline = timeline_of(setup, 3);
  std::vector<Tick> expected;
  bool was = false;
  timeline.replay(0, kNever, [&](const State&, const State& after, const referee::Events&) {
    const float x = attack_sign(after.world, Side::home) * after.world.ball.position.x;
    if (x > 1 && !was) expected.push_back(after.world.tick);
    was = x > 1;
    return true;
  });
  EXPECT_EQ(all_stops(timeline, parsed("ball_x > 1 m")), expected);
}

TEST(Stop, AFeatureIsComparedAsTheRobotComparesIt) {
  const SharedSetup setup = setup_of("baseline", "baseline", 40);
  Timeline timeline = timeline_of(setup, 5);
  const int robot = robot_of(Side::away, 3);
  std::vector<Tick> expected;
  bool is = false;
  timeline.replay(0, kNever, [&](const State& before, const State& after, const referee::Events&) {
    const bool was = is;
    if (const auto decision = decision_in(setup->params, before, robot)) {
      const Thought thought(setup->params, tree_of(setup->params, robot)->tree(), *decision);
      is = value_of(agent::find_feature("ball_distance"), thought.view()) < 0.8f;
    }
    if (is && !was) expected.push_back(after.world.tick);
    return true;
  });
  EXPECT_GT(expected.size(), 1u);
  EXPECT_EQ(all_stops(timeline, parsed("5/3 ball_distance < 0.8 m")), expected);
  EXPECT_EQ(all_stops(timeline, parsed("ball_distance < 0.8 m", robot)), expected) << "the robot in focus";
}

TEST(Stop, SkillsAndRolesAreThoseOfTheState) {
  const SharedSetup setup = setup_of("baseline", "baseline", 60);
  Timeline timeline = timeline_of(setup, 3);
  for (const Tick tick : all_stops(timeline, parsed("14/2 role changes")))
    EXPECT_NE(timeline.at(tick - 1).robots[1].mind.role, timeline.at(tick).robots[1].mind.role);
  const std::vector<Tick> kicks = all_stops(timeline, parsed("14/2 skill is kick"));
  EXPECT_FALSE(kicks.empty());
  const agent::Tree& tree = tree_of(setup->params, 1)->tree();
  for (const Tick tick : kicks) EXPECT_EQ(tree.leaf_words[timeline.at(tick).robots[1].mind.leaf].name, "kick");
}

TEST(Stop, SaysInOneSentenceWhatIsWrong) {
  EXPECT_EQ(error_of("ball_xx > 1"),
            "expected a fact about the game or a robot, got 'ball_xx > 1'; did you mean 'ball_x'?");
  EXPECT_EQ(error_of("15/3 skill changes"), "expected home/N, away/N, 14/N or 5/N, N from 1 to 4, got '15/3'");
  EXPECT_EQ(error_of("ball_error = 1"), "an error of a belief is compared by < <= > >=, got '= 1'");
  EXPECT_EQ(error_of("ball_error > 100 m"), "the value for an error of a belief must be 0 .. 30 [m], got \"100 m\"");
  EXPECT_EQ(error_of("our goal and"), "expected 'and' or 'or', got 'and'");
  EXPECT_EQ(error_of("our goal and not "), "a fact is missing");
  EXPECT_NE(error_of("skill is kik").find("did you mean 'kick'"), std::string::npos);
  EXPECT_NE(error_of("14/2 ball_distance > 99 m"), "");
  EXPECT_NE(error_of(std::string(2000, 'x')), "");
}

TEST(Stop, SurvivesEveryTruncationAndEveryFlippedByte) {
  const std::string text = "not 14/3 skill is kick and ball_x > 1 m or 5/2 ball_error >= 0.5 m and our goal";
  for (std::size_t n = 0; n < text.size(); ++n) {
    (void)error_of(text.substr(0, n));
    for (const int flip : {1, 32, 128}) {
      std::string other = text;
      other[n] = static_cast<char>(other[n] ^ flip);
      (void)error_of(other);
    }
  }
}

}  // namespace
}  // namespace sim::debug
