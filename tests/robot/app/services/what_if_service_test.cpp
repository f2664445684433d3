#include "robot/app/services/what_if_service.h"

#include <gtest/gtest.h>

#include <optional>

#include "robot/core/clock.h"
#include "robot/core/json_library.h"

namespace robot::app {
namespace {

using nlohmann::json;

struct WhatIfService : ::testing::Test {
  WhatIfService() {
    add_what_if_service(
        services, "14/2", {"baseline", "a, b"},
        [this](const std::string& robot, const foresight::WhatIf& question, std::optional<std::uint64_t> playhead_ns) {
          asked_robot = robot;
          asked = question;
          asked_at_ns = playhead_ns;
          return answer;
        });
  }

  json call(const std::string& request, net::ClientContext asker = {.loopback = true, .may_control = true}) const {
    asker.asked_ns = came_ns;
    return json::parse(services.call(1, request, asker));
  }
  std::string refusal(const std::string& request) const {
    const json said = call(request);
    EXPECT_EQ(said["ok"], false);
    return said["error"];
  }

  net::Services services;
  Result<foresight::Forecast> answer = foresight::Forecast();
  std::uint64_t came_ns = monotonic_ns();
  std::string asked_robot;
  std::optional<foresight::WhatIf> asked;
  std::optional<std::uint64_t> asked_at_ns;
};

TEST_F(WhatIfService, AsksForItsOwnRobotByDefault) {
  answer->set_choice("passing");
  const json said = call(R"({"strategies": ["baseline", "passing"], "horizon": 20})");
  EXPECT_EQ(said["ok"], true);
  EXPECT_EQ(said["robot"], "14/2");
  EXPECT_EQ(said["forecast"]["choice"], "passing");
  EXPECT_EQ(asked_robot, "14/2");
  EXPECT_EQ(asked->strategies_size(), 2);
  EXPECT_EQ(asked->horizon(), 20);
  EXPECT_EQ(asked->asked_by(), "people");

  EXPECT_EQ(call(R"({"robot": "14/3"})")["robot"], "14/3");
  EXPECT_EQ(asked_robot, "14/3");
  EXPECT_EQ(call("")["robot"], "14/2");
}

TEST_F(WhatIfService, AsksAtTheTimeOfTheAskersOwnPlayhead) {
  call("{}");
  EXPECT_EQ(asked_at_ns, std::nullopt);
  call("{}", {.loopback = true, .may_control = true, .playhead_ns = 7});
  EXPECT_EQ(asked_at_ns, 7u);
}

TEST_F(WhatIfService, AnsweredMsCountsFromTheArrivalOfTheQuestion) {
  answer->set_answered_ms(50);
  came_ns -= 7 * kSecond;  // time in the queue behind another question
  EXPECT_GE(call("{}")["forecast"]["answered_ms"], 7000);
}

TEST_F(WhatIfService, OffersItsStrategiesToEveryClientAlsoInMatchMode) {
  const net::ClientContext stranger{.address = "10.0.0.9:1", .match_mode = true};
  EXPECT_EQ(json::parse(services.call(2, "{}", stranger)),
            json::parse(R"({"ok": true, "strategies": ["baseline", "a, b"]})"));
  EXPECT_EQ(services.name(2), "/foresight/strategies");
  EXPECT_FALSE(asked);
}

TEST_F(WhatIfService, AWrongQuestionIsRefused) {
  EXPECT_EQ(refusal(R"({"robot": 14})"), "/foresight/what_if: 'robot' must be a text such as 14/2, got something else");
  EXPECT_EQ(refusal(R"({"rollouts": 1000000000})"), "/foresight/what_if: 'rollouts' is no member of a question");
  EXPECT_EQ(refusal("[]"), "/foresight/what_if: expected a JSON object, got something else");
  EXPECT_EQ(refusal(R"({"horizon":)" + std::string(100'000, '[') + std::string(100'000, ']') + "}"),
            "/foresight/what_if: expected JSON nested at most 64 deep, got deeper nesting");
  EXPECT_EQ(refusal(R"({"horizon":)" + std::string(60, '[') + std::string(60, ']') + "}").find("'horizon' must be"),
            20u);
  EXPECT_FALSE(asked);
}

TEST_F(WhatIfService, AQuestionWithoutAnswerGetsASentence) {
  answer = Error{"there is no robot '14/2'"};
  EXPECT_EQ(refusal("{}"), "/foresight/what_if: there is no robot '14/2'");
  foresight::Forecast untold;
  untold.set_refusal("nobody has seen the ball yet");
  untold.set_reason("cannot tell, because nobody has seen the ball yet");
  answer = untold;
  EXPECT_EQ(refusal("{}"), "/foresight/what_if: cannot tell, because nobody has seen the ball yet");
}

TEST_F(WhatIfService, NeedsTheTokenFromAnotherMachineAndAlsoAnswersDuringAGame) {
  const auto error = [&](const net::ClientContext& asker) { return call("{}", asker).value("error", ""); };
  EXPECT_NE(error({.address = "10.0.0.9:1"}).find("needs the control token"), std::string::npos);
  EXPECT_NE(error({.address = "10.0.0.9:1", .match_mode = true}).find("needs the control token"), std::string::npos);
  EXPECT_FALSE(asked);
  for (const bool loopback : {false, true})
    for (const bool match_mode : {false, true})
      EXPECT_EQ(error({.loopback = loopback, .may_control = true, .match_mode = match_mode}), "");
}

}  // namespace
}  // namespace robot::app
