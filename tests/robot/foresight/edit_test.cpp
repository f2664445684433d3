#include "robot/foresight/edit.h"

#include <gtest/gtest.h>

#include "robot/core/json_library.h"
#include "robot/foresight/question.h"
#include "sim/match/situation.h"
#include "tests/robot/bridge/played.h"

namespace robot::foreseeing {
namespace {

/// A situation in the middle of some game, and an edit of it.
struct Edited {
  bridge::test::Played game{"perfect"};
  sim::foresight::Situation situation{.state = sim::random_situation(game.setup.params, {.seed = 4}), .doubt = {}};

  Edited() {
    for (float& deviation : situation.doubt.position) deviation = 0.5f;
    situation.doubt.ball = 0.5f;
  }
  std::string operator()(const char* text) {
    const auto question = parse_question(nlohmann::json{{"edit", nlohmann::json::parse(text)}});
    if (!question) return question.error();
    const bridge::PlayerMaps lineups(game.recollection().game->value, game.setup.params.rules.players);
    const Result<void> applied = apply(question->edit(), lineups, game.setup.params, situation);
    return applied ? "" : applied.error();
  }
};

TEST(Edit, IsCertain) {
  Edited edit;
  EXPECT_EQ(edit(R"({"ball": {"x": 1.5, "y": -1}, "own_score": 3, "opponent_score": 1, "seconds_remaining": 100,
                     "robots": [{"side": "opponent", "player": 3, "x": -2, "y": 1, "heading": 1}]})"),
            "");
  const sim::State& state = edit.situation.state;
  const int robot = sim::robot_of(sim::Side::away, 3);
  EXPECT_EQ(state.world.ball.position, (sim::Vec2{1.5f, -1}));
  EXPECT_EQ(state.world.ball.velocity, sim::Vec2{});
  EXPECT_EQ(state.world.bodies[robot].position, (sim::Vec2{-2, 1}));
  EXPECT_EQ(state.world.bodies[robot].heading, 1);
  EXPECT_EQ(edit.situation.doubt.ball, 0);
  EXPECT_EQ(edit.situation.doubt.position[robot], 0);
  EXPECT_EQ(edit.situation.doubt.position[0], 0.5f) << "a thing that was not moved is as certain as before";
  EXPECT_EQ(state.book.score[0], 3);
  EXPECT_EQ(state.book.score[1], 1);
  EXPECT_EQ(state.book.clock, sim::ticks(edit.game.setup.params.rules.half_duration - 100));
}

TEST(Edit, NamesTheImpossiblePart) {
  Edited edit;
  EXPECT_EQ(edit(R"({"ball": {"x": 99, "y": 0}})"), "the ball at 99, 0 is not on the field");
  EXPECT_EQ(edit(R"({"ball": {"x": 3, "y": 0.7}})"), "the ball at 3, 0.7 is in a goalpost");
  EXPECT_EQ(edit(R"({"robots": [{"side": "own", "player": 2, "x": 3, "y": 0.75}]})"),
            "own player 2 at 3, 0.75 is in a goalpost");
  EXPECT_EQ(edit(R"({"robots": [{"side": "own", "player": 9, "x": 0, "y": 0}]})"),
            "own player 9 does not play: players are 1, 2, 3, 4");
  EXPECT_EQ(edit(R"({"robots": [{"side": "own", "player": 2, "x": 0, "y": 0, "heading": 7}]})"),
            "own player 2: 'heading' must be -3.1416 .. 3.1416 [rad], got 7");
  EXPECT_EQ(edit(R"({"robots": [{"side": "own", "player": 2, "x": 0, "y": 0},
                                {"side": "opponent", "player": 2, "x": 0.1, "y": 0}]})"),
            "opponent player 2 stands in another robot");
  EXPECT_EQ(edit(R"({"ball": {"x": 0, "y": 0}, "robots": [{"side": "own", "player": 2, "x": 0.05, "y": 0}]})"),
            "own player 2 stands on the ball");
  EXPECT_EQ(edit(R"({"own_score": 300})"), "a score must be 0 .. 255, got 300");
  EXPECT_EQ(edit(R"({"seconds_remaining": 601})"), "'seconds_remaining' must be 0 .. 600 [s], got 601");
}

}  // namespace
}  // namespace robot::foreseeing
