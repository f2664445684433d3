#include "sim/io/rules.h"

#include <gtest/gtest.h>

#include "sim/io/embedded.h"
#include "sim/io/source.h"

namespace sim::io {
namespace {

std::string error_of_rules(const std::string& name) {
  const auto rules = load_rules(name);
  return rules ? "" : rules.error();
}

field::Rules loaded_rules(const std::string& name) {
  const auto rules = load_rules(name);
  EXPECT_TRUE(rules) << rules.error();
  return *rules;
}

TEST(Rules, AllYearsExist) {
  EXPECT_EQ(listed(names_of("rules")), "hsl2026, spl2012, spl2025");
  const field::Rules then = loaded_rules("spl2012"), now = loaded_rules("spl2025");
  EXPECT_EQ(then.field.length, 6);
  EXPECT_EQ(then.field.width, 4);
  EXPECT_EQ(then.players, 4);
  EXPECT_EQ(then.ball_out, field::BallOut::placed_back);
  EXPECT_EQ(now.field.length, 9);
  EXPECT_EQ(now.field.width, 6);
  EXPECT_EQ(now.players, 5);
  EXPECT_EQ(now.ball_out, field::BallOut::set_play);
  EXPECT_EQ(now.message_budget, 1200);
  for (const field::Rules& rules : {then, now}) EXPECT_EQ(rules.half_duration * static_cast<float>(rules.halves), 1200);
}

TEST(Rules, TheSmallDivisionOf2026IsThatOfTheLeaguesFiles) {
  const field::Rules rules = loaded_rules("hsl2026");
  EXPECT_EQ(rules.players, 4);
  EXPECT_FLOAT_EQ(rules.field.length + rules.field.line_width, 9) << "to the outside of the lines";
  EXPECT_FLOAT_EQ(rules.field.width + rules.field.line_width, 6);
  EXPECT_EQ(rules.set_play_duration, 45);
  EXPECT_EQ(rules.penalty_duration, 30);
  EXPECT_EQ(rules.message_budget, 12000);
  EXPECT_EQ(rules.half_duration * static_cast<float>(rules.halves), 1200);
}

TEST(Rules, ANumberBehindTheNameIsTheNumberOfPlayers) {
  EXPECT_EQ(loaded_rules("spl2025:7").players, 7);
  EXPECT_EQ(error_of_rules("spl2025:8"), "rules 'spl2025:8': players must be a whole number, 1 .. 7 [robots], got 8");
  EXPECT_EQ(error_of_rules("spl2025:x"),
            "rules 'spl2025:x': players must be a whole number, 1 .. 7 [robots], got \"x\"");
}

TEST(Rules, VariationsChangeTheNamedEntries) {
  const field::Rules rules = loaded_rules("spl2012:2,half_duration=60,field.length=8,ball_out=set_play");
  EXPECT_EQ(rules.players, 2);
  EXPECT_EQ(rules.half_duration, 60);
  EXPECT_EQ(rules.field.length, 8);
  EXPECT_EQ(rules.field.width, 4);
  EXPECT_EQ(rules.ball_out, field::BallOut::set_play);
}

TEST(Rules, NamesTheError) {
  EXPECT_EQ(error_of_rules("spl2011"), "no rules 'spl2011'; did you mean 'spl2012'?");
  EXPECT_EQ(error_of_rules("spl2012,halves=0"),
            "rules 'spl2012,halves=0': halves must be a whole number, 1 .. 4, got 0");
  EXPECT_EQ(error_of_rules("spl2012,ball_out=gone"),
            "rules 'spl2012,ball_out=gone': ball_out must be \"placed_back\" or \"set_play\", got \"gone\"");
  EXPECT_EQ(
      error_of_rules("spl2012,field.goal_area_width=5"),
      "rules 'spl2012,field.goal_area_width=5': field.goal_area_width must be at most 4 [m] on this field, got 5");
  EXPECT_EQ(parse_rules(R"({"name": "mine"})", "rules 'mine'").error(), "rules 'mine': field is missing");
}

TEST(Rules, APrintedDescriptionReadsBackIdentically) {
  for (const char* name : {"spl2012", "spl2025:7", "hsl2026", "spl2012,half_duration=61.7,illegal_defender=off"}) {
    const std::string printed = print_rules(loaded_rules(name), "mine");
    const auto again = parse_rules(printed, "again");
    ASSERT_TRUE(again) << again.error();
    EXPECT_EQ(print_rules(*again, "mine"), printed);
    EXPECT_EQ(again->ball_out, loaded_rules(name).ball_out);
  }
}

TEST(Rules, PrintedRulesKeepTheirSources) {
  Sources sources, again;
  const field::Rules rules = load_rules("spl2025", &sources).value();
  ASSERT_TRUE(parse_rules(print_rules(rules, "mine", sources), "again", &again));
  EXPECT_EQ(again, sources);
}

TEST(Embedded, EveryTruncationOfRulesIsRefused) {
  for (const Embedded& file : embedded_files()) {
    if (file.kind != "rules") continue;
    for (std::size_t size = 0; size <= file.text.rfind('}'); ++size)
      EXPECT_FALSE(parse_rules(file.text.substr(0, size), "cut")) << file.name << " cut to " << size;
  }
}

}  // namespace
}  // namespace sim::io
