#include "robot/net/foxglove/parameters.h"

#include <gtest/gtest.h>

#include <atomic>
#include <limits>
#include <thread>

#include "robot/core/json_library.h"
#include "robot/net/foxglove/services.h"

namespace robot::net {
namespace {

class ParametersTest : public testing::Test {
 protected:
  Parameters parameters;
  std::string changes;

  void SetUp() override {
    parameters.declare("quality", std::int64_t{75}, {.min = 1, .max = 100});
    parameters.declare("rate", 15.0, {.min = 0.1, .max = 30});
    parameters.declare("profile", "game", {.choices = {"game", "full"}});
    parameters.declare("recording", false, {.apply = [](const ParameterValue& value) -> Result<void> {
                         if (std::get<bool>(value)) return Error{"the disk is full"};
                         return {};
                       }});
    parameters.listen([this](const std::vector<std::string>& names) {
      for (const std::string& name : names) changes += name + " ";
    });
  }
  std::string refusal(std::string_view name, const ParameterValue& value) {
    const auto set = parameters.set(name, value);
    return set ? "" : set.error();
  }
};

TEST_F(ParametersTest, TakeValuesOfTheirTypeAndRange) {
  EXPECT_TRUE(parameters.set("quality", std::int64_t{100}));
  EXPECT_EQ(parameters.integer("quality"), 100);
  EXPECT_TRUE(parameters.set("quality", 3.0));
  EXPECT_EQ(parameters.integer("quality"), 3);
  EXPECT_TRUE(parameters.set("rate", std::int64_t{1}));
  EXPECT_EQ(parameters.number("rate"), 1.0);
  EXPECT_TRUE(parameters.set("profile", "full"));
  EXPECT_EQ(parameters.text("profile"), "full");
  EXPECT_EQ(changes, "quality quality rate profile ");
}

TEST_F(ParametersTest, RefuseOthersWithASentence) {
  EXPECT_EQ(refusal("quality", std::int64_t{0}), "parameter 'quality': expected 1 .. 100, got 0");
  EXPECT_EQ(refusal("quality", 3.5), "parameter 'quality': expected a whole number, got a number");
  EXPECT_EQ(refusal("rate", 0.05), "parameter 'rate': expected 0.1 .. 30, got 0.05");
  EXPECT_NE(refusal("rate", std::numeric_limits<double>::quiet_NaN()), "");
  EXPECT_NE(refusal("rate", std::numeric_limits<double>::infinity()), "");
  EXPECT_NE(refusal("quality", 1e300), "");
  EXPECT_EQ(refusal("profile", "all"), "parameter 'profile': expected one of game, full, got 'all'");
  EXPECT_EQ(refusal("recording", "yes"), "parameter 'recording': expected true or false, got a text");
  EXPECT_EQ(refusal("recording", true), "the disk is full");
  EXPECT_FALSE(parameters.flag("recording"));
  EXPECT_EQ(refusal("speed", true), "parameter 'speed': there is no parameter of this name");
  EXPECT_EQ(changes, "");
}

TEST_F(ParametersTest, OnlyChangesAreReported) {
  parameters.update("recording", true);  // without a check every value is accepted
  parameters.update("recording", true);
  EXPECT_TRUE(parameters.set("quality", std::int64_t{75}));
  EXPECT_EQ(changes, "recording ");
}

TEST_F(ParametersTest, ARangeWithOneEndIsNamed) {
  parameters.declare("low", 1.0, {.min = 0});
  parameters.declare("high", 1.0, {.max = 1e-7});
  parameters.declare("any", 1.0);
  EXPECT_EQ(refusal("low", -0.5), "parameter 'low': expected at least 0, got -0.5");
  EXPECT_EQ(refusal("high", 2.0), "parameter 'high': expected at most 1e-07, got 2");
  EXPECT_EQ(refusal("any", std::numeric_limits<double>::infinity()),
            "parameter 'any': expected a finite number, got inf");
}

OfferedParameter number(const std::string& name, double initial, double present, ParameterRule rule = {}) {
  return {.name = name, .initial = initial, .present = present, .rule = std::move(rule)};
}

TEST_F(ParametersTest, AnOfferReplacesTheParametersOfItsPrefixAlone) {
  EXPECT_TRUE(parameters.offer("walk.", {number("walk.a", 1, 1), number("walk.b", 2, 3)}).empty());
  EXPECT_TRUE(parameters.offer("walks.", {number("walks.a", 7, 7)}).empty());
  EXPECT_EQ(changes, "walk.a walk.b walks.a ");
  EXPECT_EQ(parameters.number("walk.b"), 3);
  EXPECT_TRUE(parameters.offer("walk.", {number("walk.c", 1, 1)}).empty());
  EXPECT_FALSE(parameters.get("walk.a"));
  EXPECT_EQ(parameters.names(),
            (std::vector<std::string>{"profile", "quality", "rate", "recording", "walk.c", "walks.a"}));
}

TEST_F(ParametersTest, AValueThatWasSetOutlivesANewOffer) {
  EXPECT_TRUE(parameters.offer("walk.", {number("walk.a", 1, 1)}).empty());
  ASSERT_TRUE(parameters.set("walk.a", 5.0));
  EXPECT_TRUE(parameters.offer("walk.", {number("walk.a", 1, 2)}).empty());  // two were set: ours holds
  EXPECT_EQ(parameters.number("walk.a"), 5);
  EXPECT_TRUE(parameters.offer("walk.", {number("walk.a", 1.5, 1.5)}).empty());
  EXPECT_EQ(parameters.number("walk.a"), 5);
  ASSERT_TRUE(parameters.set("walk.a", 1.5));  // the initial value: nothing is set any more
  EXPECT_TRUE(parameters.offer("walk.", {number("walk.a", 2, 2)}).empty());
  EXPECT_EQ(parameters.number("walk.a"), 2);
}

TEST_F(ParametersTest, AValueThatDoesNotFitTheNewOfferIsNamedAndGoes) {
  EXPECT_TRUE(parameters.offer("walk.", {number("walk.a", 1, 1)}).empty());
  ASSERT_TRUE(parameters.set("walk.a", 5.0));
  EXPECT_EQ(
      parameters.offer("walk.", {number("walk.a", 1, 1, {.min = 0, .max = 2})}),
      (std::vector<std::string>{"parameter 'walk.a': the value that was set does not fit the new announcement; the "
                                "announced value holds"}));
  EXPECT_EQ(parameters.number("walk.a"), 1);
  // another type: 1.5 is no whole number
  ASSERT_TRUE(parameters.set("walk.a", 1.5));
  EXPECT_EQ(
      parameters
          .offer("walk.", {{.name = "walk.a", .initial = std::int64_t{4}, .present = std::int64_t{4}, .rule = {}}})
          .size(),
      1u);
  EXPECT_EQ(parameters.integer("walk.a"), 4);
}

TEST(Parameters, AreOfferedWhileOthersSetThem) {
  Parameters parameters;
  std::atomic<bool> done = false;
  parameters.offer("a.", {number("a.x", 0, 0)});
  std::thread setter([&] {
    for (int i = 0; !done; ++i) (void)parameters.set("a.x", static_cast<double>(i % 7));
  });
  for (int i = 0; i < 500; ++i) {
    if (i % 3 == 0)
      parameters.offer("a.", {});
    else if (i % 3 == 1)
      parameters.offer("a.", {{.name = "a.x", .initial = std::string("t"), .present = std::string("t"), .rule = {}}});
    else
      parameters.offer("a.", {number("a.x", 0, 0)});
  }
  done = true;
  setter.join();
  EXPECT_TRUE(std::holds_alternative<std::string>(*parameters.get("a.x")));
}

TEST(Parameters, AreSetAndReadByManyThreads) {
  Parameters parameters;
  parameters.declare("n", std::int64_t{0}, {.min = 0, .max = 1000});
  std::atomic<int> told = 0;
  parameters.listen([&](const std::vector<std::string>& names) {
    ++told;
    parameters.integer(names.at(0));
  });
  std::vector<std::thread> threads;
  for (int t = 0; t < 4; ++t)
    threads.emplace_back([&, t] {
      for (int i = 0; i < 200; ++i) EXPECT_TRUE(parameters.set("n", std::int64_t{(i * 4 + t) % 1000}));
    });
  for (auto& thread : threads) thread.join();
  EXPECT_GT(told, 0);
}

// services

TEST(Services, AnswerEveryRequestInJson) {
  Services services;
  services.add("double", Services::For::everybody,
               [](const nlohmann::json& request, const ClientContext&) -> nlohmann::json {
                 return {{"ok", true}, {"result", 2 * request.at("number").get<int>()}};
               });
  services.add("order", Services::For::control, [](const nlohmann::json&, const ClientContext&) -> nlohmann::json {
    return {{"ok", true}};
  });
  const ClientContext stranger{.id = 1, .address = "10.0.0.9:1"},
      friendly{.id = 2, .loopback = true, .may_control = true};
  EXPECT_EQ(services.call(1, R"({"number":21})", stranger), R"({"ok":true,"result":42})");
  EXPECT_EQ(services.call(1, "[", stranger), R"({"error":"double: expected JSON, got something else","ok":false})");
  EXPECT_EQ(services.call(1, "[]", stranger),
            R"({"error":"double: expected a JSON object, got something else","ok":false})");
  EXPECT_NE(services.call(1, R"({"number":"x"})", stranger).find(R"("ok":false)"), std::string::npos);
  EXPECT_NE(services.call(1, "{}", stranger).find(R"("ok":false)"), std::string::npos);
  EXPECT_NE(services.call(2, "{}", stranger).find("needs the control token"), std::string::npos);
  EXPECT_NE(services.call(2, "{}", stranger).find(R"("cause":"token")"), std::string::npos);
  EXPECT_EQ(services.call(2, "", friendly), R"({"ok":true})");
  ClientContext during_a_game{.may_control = true, .match_mode = true};
  EXPECT_NE(services.call(2, "", during_a_game).find("a game is in progress"), std::string::npos);
  EXPECT_NE(services.call(2, "", during_a_game).find("--practice allows it"), std::string::npos);
  EXPECT_NE(services.call(2, "", during_a_game).find(R"("cause":"game")"), std::string::npos);
  EXPECT_EQ(services.call(1, R"({"number":21})", during_a_game), R"({"ok":true,"result":42})");
  during_a_game.loopback = true;
  EXPECT_EQ(services.call(2, "", during_a_game), R"({"ok":true})");
  services.add("ask", Services::For::questions, [](const nlohmann::json&, const ClientContext&) -> nlohmann::json {
    return {{"ok", true}};
  });
  for (const bool loopback : {true, false}) {
    during_a_game.loopback = loopback;
    EXPECT_EQ(services.call(3, "", during_a_game), R"({"ok":true})");
  }
  during_a_game.may_control = false;
  EXPECT_NE(services.call(3, "", during_a_game).find("needs the control token"), std::string::npos);
  EXPECT_NE(services.call(3, "", stranger).find("needs the control token"), std::string::npos);
  EXPECT_EQ(services.call(3, "", friendly), R"({"ok":true})");
  EXPECT_FALSE(services.has(0));
  EXPECT_FALSE(services.has(4));
}

TEST(Services, ARequestThatIsNestedTooDeepIsAnsweredWithASentence) {
  Services services;
  services.add("echo", Services::For::everybody,
               [](nlohmann::json request, const ClientContext&) { return request; });  // copied, dumped, destroyed
  const std::string deep = R"({"a":)" + std::string(100'000, '[') + std::string(100'000, ']') + "}";
  EXPECT_EQ(services.call(1, deep, {}),
            R"({"error":"echo: expected JSON nested at most 64 deep, got deeper nesting","ok":false})");
}

TEST(Services, ClockSyncAnswersWithOurTimeAndTakesMeasurements) {
  Services services;
  const ManualClock clock(456);
  std::vector<PeerClock> measured;
  add_clock_sync(services, clock, [&](const PeerClock& peer) { measured.push_back(peer); });
  const ClientContext client{.id = 1, .address = "10.0.0.9:1"};
  EXPECT_EQ(services.call(1, R"({"sent_ns":"123"})", client), R"({"ok":true,"received_ns":"456","sent_ns":"123"})");
  EXPECT_TRUE(measured.empty());
  services.call(1, R"({"sent_ns":"124","offset_ns":"-5","round_trip_ns":"9"})", client);
  ASSERT_EQ(measured.size(), 1u);
  EXPECT_EQ(measured[0].peer, "10.0.0.9:1");
  EXPECT_EQ(measured[0].offset_ns, -5);
  EXPECT_EQ(measured[0].round_trip_ns, 9u);
  for (const char* wrong : {"{}", R"({"sent_ns":123})", R"({"sent_ns":"12x"})"})
    EXPECT_NE(services.call(1, wrong, client).find(R"("ok":false)"), std::string::npos);
}

}  // namespace
}  // namespace robot::net
