#include "sim/drills/drill.h"

#include <gtest/gtest.h>

#include "robot/core/json_library.h"
#include "sim/io/json.h"
#include "sim/io/source.h"

namespace sim::drills {
namespace {

using io::Json;

constexpr const char* kDrill = R"({
  "about": "one striker", "seconds": 12, "players": 3, "away": "idle",
  "start": {"ball": {"x": [0, 1], "y": 0.5}, "robots": [{"side": "home", "player": 2, "x": [-1, -0.5], "y": 0}]},
  "success": "our pass then our goal", "failure": "ball out or their goal", "time_over": "success",
  "ball_known": false, "score": {"our shot": 0.2, "ball_x > 1 m": 0.1}, "progress": {"ball_x": 0.3}
})";

/// Returns the error of kDrill with one entry replaced.
std::string refusal(const std::string& pointer, const Json& value) {
  Json json = Json::parse(kDrill);
  json[Json::json_pointer(pointer)] = value;
  const auto drill = parse_drill(json.dump(), "drill 'mine'");
  return drill ? "accepted" : drill.error();
}

TEST(Drill, IsReadAsDescribed) {
  const auto drill = parse_drill(kDrill, "drill 'mine'");
  ASSERT_TRUE(drill) << drill.error();
  EXPECT_EQ(drill->about, "one striker");
  EXPECT_EQ(drill->duration, ticks(12));
  EXPECT_EQ(drill->game.players, 3);
  EXPECT_EQ(drill->game.strategies[0], "baseline");
  EXPECT_EQ(drill->game.strategies[1], "idle");
  EXPECT_FALSE(drill->ball_known);
  EXPECT_TRUE(drill->time_is_success);
  EXPECT_EQ(drill->success.alternatives[0][0].steps.size(), 2u);
  EXPECT_EQ(drill->failure.alternatives.size(), 2u);
  ASSERT_EQ(drill->score.size(), 2u);
  EXPECT_EQ(drill->score[0].points, 0.2f);
  ASSERT_EQ(drill->progress.size(), 1u);
  EXPECT_EQ(drill->progress[0].points, 0.3f);
}

TEST(Drill, TheEndsOfTheRangesAreSituations) {
  const auto drill = parse_drill(kDrill, "drill 'mine'");
  ASSERT_TRUE(drill);
  const Json least = Json::parse(drill->least), most = Json::parse(drill->most);
  EXPECT_EQ(least["ball"]["x"], 0);
  EXPECT_EQ(most["ball"]["x"], 1);
  EXPECT_EQ(least["robots"][0]["x"], -1);
  EXPECT_EQ(most["robots"][0]["x"], -0.5);
  EXPECT_EQ(least["ball"]["y"], most["ball"]["y"]);
}

TEST(Drill, EntriesHaveTheDefaultsOfTheHeader) {
  const auto drill = parse_drill(R"({"seconds": 20, "start": {"ball": {"x": 0, "y": 0}}, "success": "our goal"})", "d");
  ASSERT_TRUE(drill) << drill.error();
  EXPECT_EQ(drill->game.rules, "spl2012");
  EXPECT_EQ(drill->game.models[0], "match");
  EXPECT_EQ(drill->game.strategies[1], "baseline");
  EXPECT_TRUE(drill->ball_known);
  EXPECT_FALSE(drill->time_is_success);
  EXPECT_TRUE(drill->failure.alternatives.empty() && drill->score.empty() && drill->progress.empty());
}

TEST(Drill, AnErrorNamesThePlace) {
  const std::string called = "drill 'mine': ";
  EXPECT_EQ(refusal("/seconds", 0), called + "seconds must be 0.1 .. 3600, got 0");
  EXPECT_EQ(refusal("/succes", "our goal"), called + "succes is unknown; did you mean 'success'?");
  EXPECT_EQ(refusal("/success", "never their goal"),
            called + "success must come true in some tick, without 'always', 'never' and 'not'");
  EXPECT_EQ(refusal("/success", "our gaol"),
            called + "success: expected a happening or a quantity, got \"our gaol\"; did you mean 'our goal'?");
  EXPECT_EQ(refusal("/time_over", "draw"), called + "time_over must be failure or success, got \"draw\"");
  EXPECT_EQ(refusal("/start/ball/x", {1, 0}), called + "start.ball.x must be [least, most], got [1,0]");
  EXPECT_EQ(refusal("/start/robots/0/x", {1, 2, 3}), called + "start.robots[0].x must be [least, most], got [1,2,3]");
  EXPECT_EQ(refusal("/score/our shot", "much"),
            called + "score.our shot must be points from -1000 to 1000, got \"much\"");
  EXPECT_EQ(refusal("/score", {{"our shot now", 1}}),
            called + "score.our shot now: expected nothing behind it, got \"now\"");
  EXPECT_EQ(refusal("/progress", {{"our shot", 1}}).substr(0, 50), called + "progress.our shot: expected a happen");
  EXPECT_EQ(parse_drill("{}", "drill 'mine'").error(), called + "start is missing");
  EXPECT_EQ(parse_drill("[]", "drill 'mine'").error().substr(0, called.size()), called);
}

TEST(Drill, SurvivesEveryTruncation) {
  const std::string text = kDrill;
  for (std::size_t n = 0; n < text.size(); ++n) EXPECT_FALSE(parse_drill(text.substr(0, n), "drill 'cut'")) << n;
}

TEST(Drill, EachShippedOneLoadsByItsName) {
  const auto names = io::names_of("drills");
  EXPECT_EQ(io::listed(names),
            "corner, counter_attack, empty_goal, keeper_clears, kick_off, pass_and_shoot, past_opponent, run_to_score, "
            "search_ball, three_against_one_with_keeper, two_against_one");
  for (const std::string_view name : names) {
    const auto drill = load_drill(std::string(name));
    ASSERT_TRUE(drill) << drill.error();
    EXPECT_EQ(drill->name, name);
    EXPECT_NE(drill->about, "");
  }
  EXPECT_EQ(load_drill("emty_goal").error(), "no drill 'emty_goal'; did you mean 'empty_goal'?");
}

}  // namespace
}  // namespace sim::drills
