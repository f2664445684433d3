#include "robot/app/services/futures_service.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <string>

#include "robot/core/encoding.h"
#include "robot/core/json_library.h"
#include "sim/match/hash.h"
#include "tests/robot/app/services/call.h"
#include "tests/robot/body/sim/support.h"

namespace robot::app {
namespace {

using nlohmann::json;

struct FuturesService : ::testing::Test {
  FuturesService() {
    EXPECT_TRUE(body->list(channels));
    EXPECT_TRUE(body->step(1500));
    add_futures_service(services, channels,
                        {.strategies = {"passing", "baseline", "passing"}, .rules = {}, .game = body.get()});
    add_futures_service(others, channels, {});
  }

  json ask(const json& request, const std::string& name = "/decision/futures") {
    return tests::call(services, name, request);
  }
  /// Asks a program that plays no game itself.
  json ask_other(const json& request) { return tests::call(others, "/decision/futures", request); }
  /// The newest objects of a robot and of the game, as a client sends them.
  json sent(const std::string& robot) {
    json request = {{"robot", robot}, {"objects", json::object()}, {"pairs", 0}};
    const auto add = [&](const std::string& name, const std::string& topic) {
      const auto version = channels.find(topic)->newest();
      ASSERT_TRUE(version) << topic;
      request["objects"][name] = {{"capture_ns", std::to_string(version->capture_ns())},
                                  {"data", to_base64(std::string(version->bytes()))}};
      if (name == "decision") request["at_ns"] = std::to_string(version->capture_ns());
    };
    for (const char* name : {"ball", "pose", "team", "opponents", "game", "motion_status", "decision"})
      add(name, "/" + robot + "/" + name);
    add("truth", "/truth/world"), add("simulation", "/sim/state");
    return request;
  }
  std::uint64_t hash() { return sim::hash_of(*body->state_at({}, {})); }
  static json robot_in(const json& places, const std::string& name) {
    for (const json& robot : places["robots"])
      if (robot["name"] == name) return robot;
    ADD_FAILURE() << name << " is not in " << places.dump();
    return {};
  }

  const SessionClock clock;
  std::unique_ptr<body::SimBody> body = std::move(*body::SimBody::open(tests::setup(), {.seed = 7}, clock));
  memory::Channels channels;
  net::Services services, others;
};

TEST_F(FuturesService, AChangeIsComparedFromTheGameItself) {
  const std::uint64_t before = hash();
  const json answer =
      ask({{"robot", "14/2"}, {"edits", {"set ball 1 0.5", "set 14/3 at -1 0.5 90"}}, {"pairs", 4}, {"seconds", 5}});
  ASSERT_EQ(answer["ok"], true) << answer.dump();
  EXPECT_EQ(answer["from"], "game");
  EXPECT_EQ(answer["robot"], "14/2");
  EXPECT_EQ(answer["side"], "home");
  EXPECT_EQ(answer["after"]["ball"], (json{{"x", 1.0}, {"y", 0.5}}));
  EXPECT_NE(answer["before"]["ball"], answer["after"]["ball"]);
  EXPECT_EQ(robot_in(answer["after"], "14/3")["x"], -1);
  const json& futures = answer["futures"];
  EXPECT_EQ(futures["pairs"], 4);
  EXPECT_EQ(futures["different"], 4);
  EXPECT_EQ(futures["seconds"], 5);
  EXPECT_LE(futures["parting"]["seconds"], 1 / 30.f + 1e-6f);
  EXPECT_NE(futures["parting"]["field"], "");
  EXPECT_EQ(futures["paths"]["with"].size(), 4u);
  EXPECT_EQ(futures["paths"]["with"][0]["ball"][0], 1);
  EXPECT_LE(futures["scores"]["low"], futures["scores"]["high"]);
  EXPECT_EQ(hash(), before) << "the game itself stays as it was";
}

TEST_F(FuturesService, TheFutureWithoutAChangeIsThatOfTheGame) {
  const json answer = ask({{"robot", "14/2"}, {"pairs", 2}, {"seconds", 10}});
  ASSERT_EQ(answer["ok"], true) << answer.dump();
  EXPECT_EQ(answer["futures"]["different"], 0);
  EXPECT_EQ(answer["futures"]["parting"], nullptr);
  const json ball = answer["futures"]["paths"]["without"][0]["ball"];
  EXPECT_EQ(answer["futures"]["paths"]["with"][0]["ball"], ball);
  const std::size_t points = ball.size() / 2;
  for (std::size_t i = 0; i < points; ++i) {
    if (i > 0) {
      ASSERT_TRUE(body->step(15));
    }
    const sim::Vec2 real = body->state_at({}, {})->world.ball.position;
    EXPECT_EQ(ball[2 * i].get<float>(), real.x) << i;
    EXPECT_EQ(ball[2 * i + 1].get<float>(), real.y) << i;
  }
}

TEST_F(FuturesService, AnyMomentOfTheGameCanBeAskedAbout) {
  const std::uint64_t then = hash();
  const json here = ask({{"robot", "14/2"}, {"pairs", 0}});
  EXPECT_EQ(here["futures"], nullptr);
  ASSERT_TRUE(body->step(300));
  EXPECT_NE(ask({{"robot", "14/2"}, {"pairs", 0}})["before"], here["before"]);
  const json again = ask({{"robot", "14/2"}, {"pairs", 0}, {"tick", 1500}, {"seed", 7}});
  EXPECT_EQ(again["before"], here["before"]);
  EXPECT_EQ(sim::hash_of(*body->state_at(7, 1500)), then);
  EXPECT_EQ(ask({{"robot", "14/2"}, {"tick", 1801}})["error"],
            "/decision/futures: simulation: 'tick' must be 0 .. 1800, got 1801");
  EXPECT_EQ(ask({{"robot", "14/2"}, {"seed", 8}})["error"],
            "/decision/futures: simulation: that moment is of the game with seed 8, and now seed 7 is played");
}

TEST_F(FuturesService, TreesAndArgumentsCanBeChanged) {
  const json answer = ask({{"robot", "14/2"},
                           {"edits", {"strategy kick_now", "set argument tolerance 20 deg of kick"}},
                           {"pairs", 4},
                           {"seconds", 30}});
  ASSERT_EQ(answer["ok"], true) << answer.dump();
  EXPECT_GT(answer["futures"]["different"], 0);
  int changed = 0;
  for (const json& leaf : answer["leaves"])
    for (const json& argument : leaf["arguments"])
      changed += argument == json{{"name", "tolerance"}, {"value", "20 deg"}};
  EXPECT_GT(changed, 0) << answer["leaves"].dump();
  EXPECT_EQ(std::ranges::count(answer["strategies"], "passing"), 1);
}

TEST_F(FuturesService, BeliefsAreTheStartWithoutAGame) {
  const json request = {{"robot", "14/2"}, {"edits", {"set 14/2 at -2 0"}}, {"pairs", 6}, {"seconds", 10}};
  const json answer = ask_other(request);
  ASSERT_EQ(answer["ok"], true) << answer.dump();
  EXPECT_EQ(answer["from"], "beliefs");
  EXPECT_EQ(answer["side"], "home");
  EXPECT_EQ(answer["attacks"], 1);
  EXPECT_EQ(robot_in(answer["after"], "14/2")["x"], -2);
  // each pair has its own draw of what is uncertain
  const json& paths = answer["futures"]["paths"]["without"];
  EXPECT_NE(paths[1]["ball"][0], paths[2]["ball"][0]);
  EXPECT_EQ(ask_other(request), answer) << "the same question has the same answer";
}

TEST_F(FuturesService, ARecordedGameIsPlayedAgain) {
  json request = sent("14/2");
  request["pairs"] = 2, request["seconds"] = 10;
  json answer = ask_other(request);
  ASSERT_EQ(answer["ok"], true) << answer.dump();
  EXPECT_EQ(answer["from"], "game");
  EXPECT_EQ(answer["tick"], 1500);
  const json live = ask({{"robot", "14/2"}, {"pairs", 2}, {"seconds", 10}});
  EXPECT_EQ(answer["futures"], live["futures"]) << "with the memories of all agents";
  // another moment of the same game, and a robot of the other side
  ASSERT_TRUE(body->step(200));
  answer = ask_other(sent("5/3"));
  EXPECT_EQ(answer["tick"], 1700);
  EXPECT_EQ(answer["side"], "away");
}

TEST_F(FuturesService, ARecordedGameThatWentAnotherWayBeginsWithBeliefs) {
  ASSERT_EQ(ask({{"robot", "14/2"}, {"edits", {"set ball 0.5 0.5"}}, {"tick", 1500}}, "/sim/edit")["ok"], true);
  ASSERT_TRUE(body->step(30));
  EXPECT_EQ(ask_other(sent("14/2"))["from"], "beliefs");
  json request = sent("14/2");
  request["objects"]["simulation"]["data"] = "////";
  EXPECT_EQ(ask_other(request)["error"], "/decision/futures: objects.simulation.data is no message of that object");
}

TEST_F(FuturesService, AnOpponentIsTheHomeSideOfItsOwnBeliefs) {
  const json answer = ask_other({{"robot", "5/2"}, {"edits", {"set 5/2 at -2 0"}}, {"pairs", 0}});
  ASSERT_EQ(answer["ok"], true) << answer.dump();
  EXPECT_EQ(answer["robot"], "5/2");
  EXPECT_EQ(robot_in(answer["after"], "5/2")["side"], "home");
  EXPECT_EQ(robot_in(answer["after"], "5/2")["x"], -2);
}

TEST_F(FuturesService, TheGameIsEditedAndGoesOnAnother) {
  ASSERT_TRUE(body->step(100));
  const std::uint64_t later = hash();
  ASSERT_TRUE(body->back(100));
  EXPECT_EQ(ask({{"robot", "14/2"}, {"edits", {"set ball 1 0.5"}}, {"tick", 1499}}, "/sim/edit")["error"],
            "/sim/edit: simulation: the game has moved on: pause it first");
  ASSERT_EQ(ask({{"robot", "14/2"}, {"edits", {"set ball 1 0.5"}}, {"tick", 1500}}, "/sim/edit")["ok"], true);
  EXPECT_TRUE(body->state().paused());
  EXPECT_EQ(body->state_at({}, {})->world.ball.position, (sim::Vec2{1, 0.5f}));
  ASSERT_TRUE(body->step(100));
  const std::uint64_t edited = hash();
  EXPECT_NE(edited, later);
  ASSERT_TRUE(body->back(50));
  ASSERT_TRUE(body->step(50));
  EXPECT_EQ(hash(), edited) << "the edited future comes again";
  ASSERT_TRUE(body->back(101));
  ASSERT_TRUE(body->step(101));
  EXPECT_EQ(hash(), later) << "going back behind the edit undoes it";
}

TEST_F(FuturesService, WrongQuestionsGetASentence) {
  const auto error = [&](const json& request) { return ask(request)["error"].get<std::string>(); };
  const auto of_edit = [&](const std::string& line) {
    return error({{"robot", "14/2"}, {"edits", {line}}, {"pairs", 2}});
  };
  const std::string start = "/decision/futures: ";
  EXPECT_EQ(error({{"robot", "99/1"}}), start + "expected home/N, away/N, 14/N or 5/N, N from 1 to 4, got '99/1'");
  EXPECT_EQ(error(json::object()), start + "'robot' must be a text of at most 1000 bytes");
  EXPECT_EQ(error({{"robot", "14/2"}, {"edits", "set"}}), start + "'edits' must be a list of at most 50 texts");
  EXPECT_EQ(error({{"robot", "14/2"}, {"edits", {7}}}), start + "'edits' must be a list of at most 50 texts");
  EXPECT_EQ(error({{"robot", "14/2"}, {"pairs", 1}}), start + "'pairs' must be 2 or more, or 0 for no futures, got 1");
  EXPECT_EQ(error({{"robot", "14/2"}, {"pairs", 1001}}), start + "'pairs' must be a whole number 0 .. 1000, got 1001");
  EXPECT_EQ(error({{"robot", "14/2"}, {"seconds", 0}}), start + "'seconds' must be a number 1 .. 120");
  EXPECT_EQ(error({{"robot", "14/2"}, {"pairs", 1000}, {"seconds", 120}}),
            start + "'pairs' times 'seconds' must be at most 30000");
  EXPECT_EQ(of_edit("step 3"), start + "'step 3': expected an edit: 'set …' or 'strategy NAME'");
  EXPECT_EQ(of_edit("strategy /etc/passwd").substr(0, 70),
            (start + "'strategy /etc/passwd': no strategy '/etc/passwd'; there are").substr(0, 70));
  EXPECT_EQ(of_edit("strategy baselin"), start + "'strategy baselin': no strategy 'baselin'; did you mean 'baseline'?");
  EXPECT_EQ(of_edit("set argument tolerence 3 deg of kick"),
            start +
                "'set argument tolerence 3 deg of kick': set argument: no leaf of 'kick' takes 'tolerence'; did you "
                "mean 'tolerance'?");
  EXPECT_EQ(ask({{"robot", "14/2"}, {"edits", {"strategy passing"}}, {"tick", 1500}}, "/sim/edit")["error"],
            "/sim/edit: 'strategy passing': a running game keeps its trees; their futures can be compared");
  EXPECT_EQ(ask({{"robot", "14/2"}, {"edits", json::array()}}, "/sim/edit")["error"],
            "/sim/edit: 'tick' must be the present tick of the game");
  EXPECT_EQ(tests::call(others, "/decision/futures", {{"robot", "99/1"}})["error"],
            "/decision/futures: robot '99/1' has not decided anything");
}

}  // namespace
}  // namespace robot::app
