#include "sim/debug/session.h"

#include <gtest/gtest.h>

#include <algorithm>

#include "tests/sim/debug/played.h"

namespace sim::debug {
namespace {

using test::kTeams;

class SessionTest : public testing::Test {
 protected:
  SessionTest()
      : setup_(test::setup_of("baseline", "passing", 90)),
        session_(setup_, sim::test::begun(setup_->params, 7), kTeams) {}

  std::string run(std::string_view line) {
    const auto text = session_.run(line);
    EXPECT_TRUE(text) << line << ": " << text.error();
    return text ? *text : "";
  }
  std::string error(std::string_view line) {
    const Tick before = session_.now();
    const auto text = session_.run(line);
    EXPECT_FALSE(text) << line;
    EXPECT_EQ(session_.now(), before) << line;
    return text ? "" : text.error();
  }

  SharedSetup setup_;
  Session session_;
};

TEST_F(SessionTest, GoesToAnyMomentAndBack) {
  run("goto 50");
  EXPECT_EQ(session_.now(), ticks(50));
  const std::string here = run("show");
  run("step 3 s"), run("back 2 s"), run("step 17 ticks");
  EXPECT_EQ(session_.now(), ticks(51) + 17);
  run("goto 2:0:10"), run("goto 50");
  EXPECT_EQ(run("show"), here);
  EXPECT_EQ(run("goto 2:0:10").find("half 2, 0:10 on the clock") != std::string::npos, true);
}

TEST_F(SessionTest, StepsAndBacksOverTheDecisionsOfTheRobotInFocus) {
  run("robot 5/3"), run("goto 60"), run("step");
  const Tick first = session_.now();
  run("step 5");
  EXPECT_GT(session_.now(), first);
  run("back 5");
  EXPECT_EQ(session_.now(), first);
  EXPECT_NE(session_.prompt().find(" 5/3> "), std::string::npos);
}

TEST_F(SessionTest, AnEditIsUndone) {
  run("goto 40");
  const std::string here = run("show");
  run("step 10 s");
  const std::string later = run("show");
  run("goto 40"), run("set ball 1 0.5");
  EXPECT_NE(run("show"), here);
  run("step 10 s");
  EXPECT_NE(run("show"), later);
  run("undo");
  EXPECT_EQ(run("show"), here);
  run("step 10 s");
  EXPECT_EQ(run("show"), later) << "the future is the old one, to the bit";
  EXPECT_EQ(error("undo"), "there is no edit to undo");
}

TEST_F(SessionTest, EditsPlacesBeliefsThresholdsLuckAndTrees) {
  run("goto 40"), run("robot 14/3");
  run("set 14/3 at -1 0.5 90");
  EXPECT_NE(run("show").find("14/3    (-1.00,  0.50) m   90 deg"), std::string::npos) << run("show");
  run("set 14/3 believes ball 0.3 0"), run("set 14/3 believes at 1 1"), run("set luck 99");
  run("strategy kick_now");
  EXPECT_NE(run("nodes"), "");
  run("robot 5/2");
  const std::string nodes = run("nodes");
  const std::size_t at = nodes.find("ball_goal_distance > $near_goal");
  ASSERT_NE(at, std::string::npos) << nodes;
  const std::size_t line = nodes.rfind('\n', at) + 1;
  const std::string number = nodes.substr(line, 4);
  EXPECT_EQ(run("set threshold " + number + " 2 m"), "ball_goal_distance > 2 m\n");
  EXPECT_NE(run("nodes").find("ball_goal_distance > 2 m"), std::string::npos);
}

TEST_F(SessionTest, ArgumentsOfLeavesAreChanged) {
  run("goto 40"), run("robot 14/2");
  EXPECT_NE(run("leaves").find("tolerance 15 deg"), std::string::npos) << run("leaves");
  EXPECT_EQ(run("set argument tolerance 20 deg of shoot"), "tolerance 20 deg of shoot\n");
  EXPECT_EQ(run("leaves").find("tolerance 15 deg"), std::string::npos) << "all leaves of that part are changed";
  EXPECT_NE(run("leaves").find("tolerance 45 deg"), std::string::npos) << "and no others";
  run("set argument kick side of set play");
  EXPECT_NE(run("leaves").find("kick side"), std::string::npos) << run("leaves");
  run("undo"), run("undo");
  EXPECT_NE(run("leaves").find("tolerance 15 deg"), std::string::npos);
  EXPECT_EQ(error("set argument tolerance 20 deg").substr(0, 23), "expected: set ball X Y,");
  EXPECT_EQ(error("set argument tolerance 20 deg of").substr(0, 23), "expected: set ball X Y,");
  EXPECT_EQ(error("set argument tolerance 20 m of kick"),
            "set argument: the argument 'tolerance' must be in rad, got \"20 m\"");
  EXPECT_EQ(error("set argument aim goal of search_ball").substr(0, 50),
            "set argument: no leaf of 'search_ball' takes 'aim'");
  EXPECT_NE(error("set argument kick sdie of kick").find("no kick"), std::string::npos);
}

TEST_F(SessionTest, ExplainsAndAsksWhyNot) {
  run("until our touch"), run("robot 14/2");
  const std::string why = run("why");
  EXPECT_TRUE(why.starts_with("14/2 plays ")) << why;
  EXPECT_NE(why.find("believed"), std::string::npos);
  const std::string not_dribble = run("whynot dribble");
  EXPECT_TRUE(not_dribble.find("would have to be different") != std::string::npos ||
              not_dribble.find("does play") != std::string::npos)
      << not_dribble;
  EXPECT_NE(run("whynot before the goal"), "");
  EXPECT_EQ(error("whynot pas").substr(0, 49), "strategy 'baseline' has no skill or rule 'pas'; i");
}

TEST_F(SessionTest, ComparesFuturesWithAndWithoutTheEditsOfAMoment) {
  run("goto 40"), run("robot 14/2");
  EXPECT_EQ(error("futures 10 5"), "futures compares with and without an edit, and there is none");
  run("set ball 2 0"), run("step 2 s");
  const std::string text = run("futures 10 5");
  EXPECT_TRUE(text.starts_with("for 14/2's side\n10 pairs of futures of 5 s")) << text;
  EXPECT_NE(text.find("they part at 40.0"), std::string::npos) << text;
}

TEST_F(SessionTest, GoesToTheNearestOfItsBreakpoints) {
  EXPECT_EQ(run("break"), "no breakpoints\n");
  EXPECT_EQ(error("continue"), "continue: there is no breakpoint; 'break CONDITION' sets one");
  run("goto 20"), run("robot 14/2");
  const Tick begin = session_.now();
  std::vector<Tick> moments;
  for (const char* condition : {"skill changes", "our touch"}) {
    run("until " + std::string(condition));
    moments.push_back(session_.now());
    run("goto 20");
    EXPECT_NE(run("break " + std::string(condition)), "");
  }
  EXPECT_EQ(run("break"), "  1  14/2 skill changes\n  2  our touch\n");
  EXPECT_EQ(session_.breakpoints(), (std::vector<std::string>{"14/2 skill changes", "our touch"}));
  run("robot 5/2");  // a breakpoint keeps its robot
  const std::string there = run("continue");
  EXPECT_EQ(session_.now(), std::min(moments[0], moments[1]));
  EXPECT_NE(there.find(moments[0] <= moments[1] ? "breakpoint 1: 14/2 skill changes\n" : "breakpoint 2: our touch\n"),
            std::string::npos)
      << there;
  const Tick first = session_.now();
  run("continue"), run("reverse-continue");
  EXPECT_EQ(session_.now(), first);
  EXPECT_GT(first, begin);
  EXPECT_EQ(run("unbreak 1"), "");
  EXPECT_EQ(run("break"), "  1  our touch\n");
  EXPECT_EQ(error("unbreak 2"), "unbreak: expected the number of a breakpoint, got '2'; 'break' lists them");
  run("unbreak 1"), run("break ball_x > 14 m");
  EXPECT_EQ(error("continue"), "no breakpoint is met after this moment");
}

TEST_F(SessionTest, BadInputIsOneSentenceAndChangesNothing) {
  run("goto 40");
  EXPECT_EQ(error("gto 3"), "no command 'gto'; did you mean 'goto'?");
  EXPECT_EQ(error("frobnicate"), "no command 'frobnicate'; 'help' lists all");
  EXPECT_EQ(error("step x"), "expected: step [N] [s|ticks]");
  EXPECT_EQ(error("back 0"), "back: expected a number from 1 to 100000, got 0");
  EXPECT_EQ(error("robot 14/9"), "expected home/N, away/N, 14/N or 5/N, N from 1 to 4, got '14/9'");
  EXPECT_EQ(error("set ball 99 0"), "set ball: X must be -3.71 .. 3.71 [m], got \"99\"");
  EXPECT_EQ(error("set threshold 4000 1"), "set threshold: expected a node from 0 to 28, got '4000'");
  EXPECT_EQ(error("strategy baselin").find("did you mean 'baseline'") != std::string::npos, true);
  EXPECT_EQ(error("until ball_x > 14 m"), "'ball_x > 14 m' does not become true after this moment");
  EXPECT_TRUE(error("goto 99999").starts_with("a moment must be ")) << error("goto 99999");
  EXPECT_TRUE(error("goto 9999").starts_with("the game ends ")) << error("goto 9999");
  EXPECT_EQ(error("set 14/2 at 1"), "set 14/2: expected X and Y [m], got '1'");
  EXPECT_EQ(error("set 14/2 at 0 0 400"), "set 14/2: the heading in degrees must be -180 .. 180, got \"400\"");
  EXPECT_EQ(run(""), "");
  EXPECT_EQ(run("# a comment"), "");
  for (const CommandInfo& info : commands()) {
    const auto text = session_.run(std::string(info.name) + " \xff\x01 zzz");
    if (!text) {
      EXPECT_EQ(text.error().find('\n'), std::string::npos);
    }
  }
}

TEST_F(SessionTest, CompletesCommandsRobotsAndWords) {
  const auto has = [](const std::vector<std::string>& words, std::string_view word) {
    return std::ranges::find(words, word) != words.end();
  };
  EXPECT_TRUE(has(session_.completions("wh"), "whynot"));
  EXPECT_FALSE(has(session_.completions("wh"), "goto"));
  EXPECT_TRUE(has(session_.completions("why 14/"), "14/3"));
  EXPECT_TRUE(has(session_.completions("whynot dr"), "dribble"));
  EXPECT_TRUE(has(session_.completions("until ball_d"), "ball_distance"));
}

TEST_F(SessionTest, TheHelpHasEveryCommand) {
  for (const CommandInfo& info : commands()) EXPECT_NE(run("help").find(info.usage), std::string::npos);
}

}  // namespace
}  // namespace sim::debug
