#include "sim/guest/wire.h"

#include <gtest/gtest.h>

#include "robot/core/json_library.h"
#include "sim/guest/moment.h"
#include "tests/sim/agent/scene.h"

namespace sim::guest {
namespace {

using Json = nlohmann::json;

ForesightPlayer player(const agent::Scene& scene) { return player_of(agent::surroundings(), scene.game, 7); }

TEST(Wire, TheGreetingHasTheConstantsOfTheGame) {
  const agent::Scene scene;
  const Json json = Json::parse(greeting_of(player(scene)));
  EXPECT_EQ(json["version"], FORESIGHT_BEHAVIOUR_VERSION);
  EXPECT_EQ(json["players"], 4);
  EXPECT_EQ(json["field"]["length"].get<float>(), agent::surroundings().rules->field.length);
  EXPECT_EQ(json["walk"]["forward"].get<float>(), agent::surroundings().motion->walk.forward);
  EXPECT_EQ(json["kicks"].size(), static_cast<std::size_t>(agent::surroundings().motion->kick_count));
  EXPECT_EQ(json["kicks"][0]["name"], agent::surroundings().motion->kicks[0].name);
}

TEST(Wire, AQuestionHasAllBeliefsToTheBit) {
  std::mt19937 random(3);
  for (int i = 0; i < 500; ++i) {
    const agent::Scene scene = agent::random_scene(random);
    const ForesightMoment moment = moment_of(scene.game, scene.beliefs, scene.now, i % 2 == 0);
    const std::string line = question_of(player(scene), moment);
    ASSERT_EQ(line.back(), '\n');
    const Json json = Json::parse(line);
    EXPECT_EQ(json["player"], scene.game.player);
    EXPECT_EQ(json["entered"], i % 2 == 0);
    EXPECT_EQ(json["x"].get<float>(), moment.x);
    EXPECT_EQ(json["ball"]["vx"].get<float>(), moment.ball_vx);
    EXPECT_EQ(json["ball"]["seen"].is_null(), moment.ball_seen == FORESIGHT_NEVER);
    for (const Json& mate : json["mates"]) {
      const ForesightMate& told = moment.mates[mate["player"].get<int>() - 1];
      EXPECT_EQ(mate["x"].get<float>(), told.x);
      EXPECT_EQ(mate["time_to_ball"].get<float>(), told.time_to_ball);
    }
    for (const Json& opponent : json["opponents"])
      EXPECT_EQ(opponent["seen"], moment.opponents[opponent["player"].get<int>() - 1].seen);
  }
}

TEST(Wire, AnAnswerIsACommand) {
  const agent::Scene scene;
  ForesightCommand command = usual_command(scene.mind);
  EXPECT_EQ(read_answer("{}", player(scene), command), "");
  EXPECT_EQ(command.body, FORESIGHT_USUAL);
  EXPECT_EQ(read_answer(R"({"body": "kick", "kick": "long", "kick_left": true, "gain": 0.5, "head": "look_to",
                            "look": [1, 2, 0.05], "role": "chaser", "time_to_ball": 3})",
                        player(scene), command),
            "");
  EXPECT_EQ(command.body, FORESIGHT_KICK);
  EXPECT_STREQ(player(scene).kicks[command.kick].name, "long");
  EXPECT_TRUE(command.kick_left);
  EXPECT_EQ(command.look[2], 0.05f);
  EXPECT_EQ(command.role, FORESIGHT_CHASER);
}

TEST(Wire, AWrongAnswerIsASentence) {
  const agent::Scene scene;
  const auto problem = [&](const std::string& answer) {
    ForesightCommand command = usual_command(scene.mind);
    return read_answer(answer, player(scene), command);
  };
  EXPECT_EQ(problem("hello"), "expected a JSON object as answer, got 'hello'");
  EXPECT_EQ(problem("[1]"), "expected a JSON object as answer, got '[1]'");
  EXPECT_EQ(problem(R"({"x": "far"})"), "x must be a number, got \"far\"");
  EXPECT_EQ(problem(R"({"kick": "hard"})"), "kick must be the name of a kick, got \"hard\"");
  EXPECT_EQ(problem(R"({"look": [1, 2]})"), "look must be a list of three numbers, got [1,2]");
  EXPECT_EQ(problem(R"({"kick_left": 1})"), "kick_left must be true or false, got 1");
  EXPECT_NE(problem(R"({"boddy": "kick"})").find("got something else: '{\"boddy\":\"kick\"}'"), std::string::npos);
  EXPECT_NE(check_greeting(R"({"version": 2})").find("expected {\"version\": 1, …} as the first answer"),
            std::string::npos);
  // printed, such an answer would end the simulator
  const std::string deep = std::string(100'000, '[') + std::string(100'000, ']');
  EXPECT_NE(problem(R"({"look": )" + deep + "}").find("expected a JSON object as answer, got '{\"look\": [[["),
            std::string::npos);
  EXPECT_NE(check_greeting(R"({"version": )" + deep + "}").find("expected a JSON object as answer"), std::string::npos);
  const std::string whole = R"({"body": "kick", "look": [1, 2, 3]})";
  for (std::size_t n = 0; n < whole.size(); ++n) EXPECT_NE(problem(whole.substr(0, n)), "") << n;
}

}  // namespace
}  // namespace sim::guest
