#include "robot/app/services/simulation_service.h"

#include <gtest/gtest.h>

#include <map>
#include <string>
#include <vector>

#include "robot/core/json_library.h"
#include "tests/robot/app/services/call.h"
#include "tests/robot/body/sim/support.h"

namespace robot::app {
namespace {

using nlohmann::json;

struct SimulationService : ::testing::Test {
  SimulationService() { add_simulation_service(*body, services); }

  json call(const std::string& name, const json& request = json::object()) {
    return tests::call(services, name, request);
  }

  const SessionClock clock;
  std::unique_ptr<body::SimBody> body = std::move(*body::SimBody::open(tests::setup(), {.seed = 7}, clock));
  net::Services services;
};

TEST_F(SimulationService, StateReportsTheGame) {
  const json state = call("/sim/state");
  EXPECT_EQ(state["ok"], true);
  EXPECT_EQ(state["paused"], false);
  EXPECT_EQ(state["finished"], false);
  EXPECT_EQ(state["speed"], 1);
  EXPECT_EQ(state["seed"], 7);
  EXPECT_EQ(state["tick"], 0);
  EXPECT_EQ(state["rules"], "spl2012");
  EXPECT_EQ(state["home"], (json{{"number", 14}, {"strategy", "baseline"}, {"models", "match"}, {"score", 0}}));
  EXPECT_EQ(state["away"]["number"], 5);
}

TEST_F(SimulationService, EachServiceActsAndAnswersWithTheState) {
  EXPECT_EQ(call("/sim/step")["tick"], 1);
  const json stepped = call("/sim/step", {{"ticks", 29}});
  EXPECT_EQ(stepped["tick"], 30);
  EXPECT_EQ(stepped["paused"], true);
  EXPECT_EQ(stepped["seconds"], 1.0);
  EXPECT_EQ(call("/sim/back")["tick"], 29);
  EXPECT_EQ(call("/sim/back", {{"ticks", 9}})["tick"], 20);
  EXPECT_EQ(call("/sim/resume")["paused"], false);
  EXPECT_EQ(call("/sim/pause")["paused"], true);
  EXPECT_EQ(call("/sim/speed", {{"speed", 2.5}})["speed"], 2.5);
  EXPECT_EQ(call("/sim/seed", {{"seed", 8}})["seed"], 8);
  EXPECT_EQ(call("/sim/state")["tick"], 0);
  call("/sim/step");
  const json again = call("/sim/reset");
  EXPECT_EQ(again["seed"], 8);
  EXPECT_EQ(again["tick"], 0);
  EXPECT_EQ(call("/sim/reset", {{"seed", 9}})["seed"], 9);
}

TEST_F(SimulationService, ResetWithASituationContinuesFromIt) {
  const json situation = {{"ball", {{"x", 1.25}, {"y", -0.5}}},
                          {"robots", {{{"side", "home"}, {"player", 2}, {"x", 1}, {"y", -0.5}}}},
                          {"score", {{"home", 2}, {"away", 1}}},
                          {"seed", 5}};
  const json reset = call("/sim/reset", {{"situation", situation}});
  EXPECT_EQ(reset["ok"], true) << reset;
  EXPECT_EQ(reset["seed"], 5);
  EXPECT_EQ(reset["home"]["score"], 2);
  EXPECT_EQ(call("/sim/reset", {{"situation", situation}, {"seed", 6}})["seed"], 6);
  const auto truth = body->memory()->truth.read();
  EXPECT_FLOAT_EQ(truth->value().ball().x(), 1.25f);
  EXPECT_FLOAT_EQ(truth->value().ball().y(), -0.5f);
}

TEST_F(SimulationService, ResetTakesTheNameOfAnEmbeddedSituationAndNoPath) {
  const json kick_off = call("/sim/reset", {{"seed", 5}});
  const auto x = [&] { return body->memory()->truth.read()->value().ball().x(); };
  EXPECT_EQ(x(), 0);
  const json reset = call("/sim/reset", {{"situation", "near_free"}, {"seed", 6}});
  EXPECT_EQ(reset["ok"], true) << reset;
  EXPECT_EQ(reset["seed"], 6);
  EXPECT_NE(x(), 0);
  EXPECT_EQ(call("/sim/reset", {{"situation", "near_fre"}})["error"],
            "/sim/reset: no situation 'near_fre'; did you mean 'near_free'?");
  for (const char* path : {"/etc/passwd", "./near_free.json", "../../near_free", ""}) {
    const json refused = call("/sim/reset", {{"situation", path}});
    EXPECT_EQ(refused["error"].get<std::string>().find("/sim/reset: no situation '" + std::string(path) + "'"), 0u)
        << refused;
  }
}

TEST_F(SimulationService, ABadRequestGetsOneSentenceAndChangesNothing) {
  const json before = call("/sim/state");
  const std::map<std::string, std::vector<json>> bad = {
      {"/sim/step", {{{"ticks", 0}}, {{"ticks", -1}}, {{"ticks", 1801}}, {{"ticks", 1.5}}, {{"ticks", "1"}}}},
      {"/sim/speed", {json::object(), {{"speed", 0}}, {{"speed", 101}}, {{"speed", "fast"}}, {{"speed", nullptr}}}},
      {"/sim/seed", {json::object(), {{"seed", -1}}, {{"seed", 1.5}}, {{"seed", 9007199254740992}}, {{"seed", "7"}}}},
      {"/sim/reset",
       {{{"seed", "7"}}, {{"situation", 7}}, {{"situation", {{"balls", 2}}}}, {{"situation", {{"ball", 3}}}}}},
  };
  for (const auto& [service, requests] : bad)
    for (const json& request : requests) {
      const json answer = call(service, request);
      EXPECT_EQ(answer["ok"], false) << service << request;
      const std::string sentence = answer["error"];
      EXPECT_GT(sentence.size(), 20u) << service << request;
      EXPECT_EQ(sentence.find('\n'), std::string::npos) << sentence;
    }
  EXPECT_EQ(call("/sim/state"), before);
  EXPECT_EQ(call("/sim/seed", {{"seed", -1}})["error"],
            "/sim/seed: 'seed' must be a whole number 0 .. 9007199254740991, got -1");
}

TEST_F(SimulationService, WholeNumbersMayBeSpelledAsDecimalFractions) {
  EXPECT_EQ(call("/sim/seed", json::parse(R"({"seed": 7.0})"))["seed"], 7);
  EXPECT_EQ(call("/sim/seed", json::parse(R"({"seed": 8e0})"))["seed"], 8);
  const json begun = call(
      "/sim/reset",
      json::parse(
          R"({"seed": 9.0, "situation": {"seed": 3.0, "ball": {"x": 1.0, "y": 0.0}, "robots": [], "score": {"home": 2e0}}})"));
  ASSERT_TRUE(begun.value("ok", false)) << begun;
  EXPECT_EQ(begun["seed"], 9);
  EXPECT_EQ(begun["home"]["score"], 2);
}

TEST_F(SimulationService, OnlyTheStateNeedsNoToken) {
  for (const auto& service : services.list()) {
    const json answer = json::parse(services.call(service.id, "{}", {.may_control = false}));
    EXPECT_EQ(answer["ok"], service.name == "/sim/state") << service.name;
  }
}

}  // namespace
}  // namespace robot::app
