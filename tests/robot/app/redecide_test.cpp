#include "robot/app/redecide.h"

#include <gtest/gtest.h>

namespace robot::app {
namespace {

namespace pb = foresight;

pb::DecisionTrace trace_of(const std::string& skill, const std::string& condition = "ball_known", bool result = true) {
  pb::DecisionTrace trace;
  trace.set_strategy("recorded");
  trace.set_skill(skill);
  auto* node = trace.add_visited();
  node->set_condition(condition), node->set_result(result), node->set_value(0.43f), node->set_threshold(0.5f);
  trace.add_visited()->set_path("tree/" + skill);
  return trace;
}

/// Decisions a tenth of a second apart.
Redecisions some() {
  Redecisions decisions{.robot = "14/2", .strategy = "mine", .recorded_strategy = "recorded", .all = {}};
  const auto add = [&](const char* recorded, const char* now) {
    decisions.all.push_back({.seconds = 0.1 * static_cast<double>(decisions.all.size()),
                             .recorded = trace_of(recorded, "ball_distance < 0.5", false),
                             .now = trace_of(now, "ball_distance < 0.5", true),
                             .problem = ""});
  };
  add("kick", "kick"), add("kick", "dribble"), add("kick", "dribble"), add("block", "dribble"), add("block", "block");
  return decisions;
}

TEST(Redecide, ListsStretchesOfDifferentDecisionsAndWhereTheyPart) {
  EXPECT_EQ(to_text(some()),
            "14/2: 5 decisions in play by recorded; mine decides 3 of them (60.0 %) otherwise\n"
            "     0.10 .. 0.20      s  kick -> dribble; ball_distance < 0.5: recorded no (0.43), now yes (0.43)\n"
            "     0.30 .. 0.30      s  block -> dribble; ball_distance < 0.5: recorded no (0.43), now yes (0.43)\n");
}

TEST(Redecide, ItsTableHasBothDecisions) {
  EXPECT_EQ(to_csv(some()),
            "time [s],recorded skill,recorded leaf,skill,leaf,where they part\n"
            "0.0000,kick,tree/kick,kick,tree/kick,\n"
            "0.1000,kick,tree/kick,dribble,tree/dribble,\"ball_distance < 0.5: recorded no (0.43), now yes (0.43)\"\n"
            "0.2000,kick,tree/kick,dribble,tree/dribble,\"ball_distance < 0.5: recorded no (0.43), now yes (0.43)\"\n"
            "0.3000,block,tree/block,dribble,tree/dribble,\"ball_distance < 0.5: recorded no (0.43), now yes (0.43)\"\n"
            "0.4000,block,tree/block,block,tree/block,\n");
}

TEST(Redecide, OtherArgumentsOfTheSameSkillAreADifference) {
  Redecisions decisions{.robot = "14/2", .strategy = "mine", .recorded_strategy = "recorded", .all = {}};
  decisions.all.push_back({.seconds = 0, .recorded = trace_of("go_to"), .now = trace_of("go_to"), .problem = ""});
  EXPECT_FALSE(decisions.all[0].differs());
  for (auto [trace, x] : {std::pair(&decisions.all[0].recorded, 1.f), std::pair(&decisions.all[0].now, 2.f)}) {
    auto* argument = trace->add_arguments();
    argument->set_name("x"), argument->set_value(x);
  }
  EXPECT_TRUE(decisions.all[0].differs());
  EXPECT_NE(to_text(decisions).find("go_to (x 1) -> go_to (x 2); another skill or other arguments"), std::string::npos)
      << to_text(decisions);
}

TEST(Redecide, NamesWhatOtherTreesAskInstead) {
  const Redecision other{
      .seconds = 0, .recorded = trace_of("kick", "ball_x > 1"), .now = trace_of("block", "ball_y > 1"), .problem = ""};
  EXPECT_EQ(parting(other), "where 'ball_x > 1' was asked, it asks 'ball_y > 1'");
  const Redecision blind{.seconds = 0, .recorded = trace_of("kick"), .now = {}, .problem = "the pose is old"};
  EXPECT_EQ(parting(blind), "the pose is old");
}

TEST(Redecide, ExpectationsHoldOrAreBrokenWithTheirLine) {
  const auto expectations = parse_expectations(
      "# what must hold\n"
      "at 0.15 s: dribble or kick\n"
      "0.1 .. 0.3 s: not kick\n"
      "\n"
      "0 .. 0.4 s: dribble\n"
      "at 0.05 s: not kick\n"
      "7 .. 8 s: kick\n");
  ASSERT_TRUE(expectations) << expectations.error();
  ASSERT_EQ(expectations->size(), 5u);
  EXPECT_EQ(broken(*expectations, some()),
            (std::vector<std::string>{"line 5, '0 .. 0.4 s: dribble': at 0.00 s it plays kick",
                                      "line 6, 'at 0.05 s: not kick': at 0.00 s it plays kick",
                                      "line 7, '7 .. 8 s: kick': there is no decision in play"}));
}

TEST(Redecide, AWrongExpectationIsNamedByItsLine) {
  for (const char* line : {"at 5: kick", "at x s: kick", "5 .. 4 s: kick", "5 s: kick", "at -1 s: kick", "at 5 s kick",
                           "at 5 s:", "at 5 s: not", "at 5 s: kik", "at 5 s: kick or", "at 1e99 s: kick"}) {
    const auto parsed = parse_expectations("at 1 s: kick\n" + std::string(line));
    ASSERT_FALSE(parsed) << line;
    EXPECT_TRUE(parsed.error().starts_with("line 2: ")) << parsed.error();
  }
}

}  // namespace
}  // namespace robot::app
