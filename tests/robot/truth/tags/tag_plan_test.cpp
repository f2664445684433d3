#include "robot/truth/tags/tag_plan.h"

#include <gtest/gtest.h>

#include <numbers>
#include <utility>

#include "robot/core/files.h"
#include "tests/support/temporary_folder.h"

namespace {

using robot::truth::tags::parse_tag_plan;
using robot::truth::tags::read_tag_plan;

const std::string kPlan = R"({"family": "tag25h9", "teams": [5, 18], "tags": [
  {"id": 0, "team": 5, "player": 1, "edge": 0.14, "height": 0.56, "forward": 0.02, "left": -0.05, "turn_deg": 90},
  {"id": 7, "team": 18, "player": 20, "edge": 0.12, "height": 0.5}]})";

/// Returns a plan with one tag that has these members.
std::string with_tag(const std::string& members) { return R"({"teams": [5], "tags": [{)" + members + "}]}"; }

TEST(TagPlan, HasTheMountingOfEachTag) {
  const auto plan = parse_tag_plan(kPlan);
  ASSERT_TRUE(plan) << plan.error();
  EXPECT_EQ(plan->family, "tag25h9");
  ASSERT_EQ(plan->tags.size(), 2u);
  const auto& first = plan->tags.at(0);
  EXPECT_EQ(first.team, 5u);
  EXPECT_EQ(first.player, 1u);
  EXPECT_EQ(first.mounting.edge, 0.14);
  EXPECT_EQ(first.mounting.height, 0.56);
  EXPECT_EQ(first.mounting.forward, 0.02);
  EXPECT_EQ(first.mounting.left, -0.05);
  EXPECT_NEAR(first.mounting.turn, std::numbers::pi / 2, 1e-12);
  EXPECT_EQ(plan->tags.at(7).mounting.turn, 0);
}

TEST(TagPlan, TheFamilyIs36h11IfItIsAbsent) {
  const auto plan = parse_tag_plan(with_tag(R"("id": 586, "team": 5, "player": 1, "edge": 0.1, "height": 0.5)"));
  ASSERT_TRUE(plan) << plan.error();
  EXPECT_EQ(plan->family, "tag36h11");
}

TEST(TagPlan, SaysTheFirstFaultAndItsPlace) {
  const std::pair<std::string, std::string> cases[] = {
      {"[]", "tag plan: expected an object, got []"},
      {"{", "tag plan: expected JSON, got something else"},
      {R"({"team": [5]})", "tag plan: expected one of the keys family, teams, tags, got 'team'"},
      {R"({"family": "tag16h5"})", R"(tag plan: family: expected tag36h11, tag36h10 or tag25h9, got "tag16h5")"},
      {R"({"family": 3})", "tag plan: family: expected tag36h11, tag36h10 or tag25h9, got 3"},
      {R"({"tags": []})", "tag plan: teams: expected a list of team numbers, got null"},
      {R"({"teams": [5.5]})", "tag plan: teams: expected a whole number 0 .. 255, got 5.5"},
      {R"({"teams": [5]})", "tag plan: tags: expected a list of tags, got null"},
      {R"({"teams": [5], "tags": [7]})", "tag plan: entry 1 of tags: expected an object, got 7"},
      {with_tag(R"("Id": 1)"),
       "tag plan: entry 1 of tags: expected one of the keys id, team, player, edge, height, forward, left, turn_deg, "
       "got 'Id'"},
      {with_tag(R"("id": 587)"), "tag plan: entry 1 of tags: id: expected a whole number 0 .. 586, got 587"},
      {with_tag(R"("id": 1, "team": "red")"), R"(tag plan: tag 1: team: expected a whole number 0 .. 255, got "red")"},
      {with_tag(R"("id": 1, "team": 5, "player": 0)"),
       "tag plan: tag 1: player: expected a whole number 1 .. 20, got 0"},
      {with_tag(R"("id": 1, "team": 5, "player": 1)"), "tag plan: tag 1: edge: expected 0.03 .. 0.5 m, got null"},
      {with_tag(R"("id": 1, "team": 5, "player": 1, "edge": 14)"),
       "tag plan: tag 1: edge: expected 0.03 .. 0.5 m, got 14"},
      {with_tag(R"("id": 1, "team": 5, "player": 1, "edge": 0.1, "height": 50)"),
       "tag plan: tag 1: height: expected 0.05 .. 1.5 m, got 50"},
      {with_tag(R"("id": 1, "team": 5, "player": 1, "edge": 0.1, "height": 0.5, "forward": "x")"),
       R"(tag plan: tag 1: forward: expected -0.5 .. 0.5 m, got "x")"},
      {with_tag(R"("id": 1, "team": 5, "player": 1, "edge": 0.1, "height": 0.5, "turn_deg": 400)"),
       "tag plan: tag 1: turn_deg: expected -360 .. 360 degrees, got 400"},
      {with_tag(R"("id": 1, "team": 6, "player": 1, "edge": 0.1, "height": 0.5)"),
       "tag plan: tag 1: team: expected one of the plan's teams, got 6"},
      {with_tag(R"("id": 1, "team": 5, "player": 1, "edge": 0.1, "height": 0.5},
                  {"id": 1, "team": 5, "player": 2, "edge": 0.1, "height": 0.5)"),
       "tag plan: tag 1: expected each id once, got it twice"},
  };
  for (const auto& [text, sentence] : cases) {
    const auto plan = parse_tag_plan(text);
    ASSERT_FALSE(plan) << text;
    EXPECT_EQ(plan.error(), sentence);
  }
}

TEST(TagPlan, SurvivesEveryTruncationAndFlippedByte) {
  for (std::size_t n = 0; n < kPlan.size(); ++n) {
    EXPECT_FALSE(parse_tag_plan(kPlan.substr(0, n))) << n;
    std::string flipped = kPlan;
    flipped[n] = static_cast<char>(flipped[n] ^ 0x10);
    const auto plan = parse_tag_plan(flipped);
    EXPECT_TRUE(plan || plan.error().find('\n') == std::string::npos);
  }
}

TEST(TagPlan, AFileIsNamedInTheError) {
  const tests::TemporaryFolder folder;
  const auto file = folder / "tags.json";
  EXPECT_FALSE(read_tag_plan(file));
  ASSERT_TRUE(robot::replace_file(file, kPlan));
  EXPECT_TRUE(read_tag_plan(file));
  ASSERT_TRUE(robot::replace_file(file, "[]"));
  EXPECT_EQ(read_tag_plan(file).error(), file.string() + ": tag plan: expected an object, got []");
}

}  // namespace
