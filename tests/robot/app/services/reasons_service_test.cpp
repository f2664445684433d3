#include "robot/app/services/reasons_service.h"

#include <gtest/gtest.h>

#include <string>

#include "robot/core/json_library.h"
#include "sim/io/situation.h"
#include "tests/robot/app/services/call.h"
#include "tests/robot/body/sim/support.h"

namespace robot::app {
namespace {

using nlohmann::json;

struct ReasonsService : ::testing::Test {
  ReasonsService() {
    EXPECT_TRUE(body->list(channels));
    add_reasons_service(services, channels, {});
  }

  json call(const std::string& name, const json& request) { return tests::call(services, name, request); }

  const SessionClock clock;
  std::unique_ptr<body::SimBody> body = std::move(*body::SimBody::open(tests::setup(), {.seed = 7}, clock));
  memory::Channels channels;
  net::Services services;
};

TEST_F(ReasonsService, DecisionsOfAGameAreMadeAgainFromTheBeliefs) {
  ASSERT_TRUE(body->step(1500));
  int asked = 0, agreed = 0;
  std::size_t sources = 0;
  for (int moment = 0; moment < 20; ++moment) {
    ASSERT_TRUE(body->step(37));
    for (const char* robot : {"14/1", "14/2", "14/3", "14/4", "5/1", "5/2", "5/3", "5/4"}) {
      const json answer = call("/decision/why", {{"robot", robot}});
      if (answer["ok"] == false) {
        EXPECT_NE(answer["error"].get<std::string>().find("decides nothing now"), std::string::npos) << answer.dump();
        continue;
      }
      if (answer["reasons"]["plays"] == false) continue;
      ++asked;
      agreed += answer["agrees"] == true;
      EXPECT_EQ(answer["has_truth"], true);
      for (const json& reason : answer["reasons"]["path"]) sources += reason["sources"].size();
    }
  }
  EXPECT_GT(asked, 100);
  EXPECT_GT(sources, 100u);
  EXPECT_GE(agreed, asked * 98 / 100) << asked;  // the memory of a behaviour is not recorded
}

TEST_F(ReasonsService, WhyNotLeadsThere) {
  ASSERT_TRUE(body->step(1500));
  const json answer = call("/decision/why_not", {{"robot", "14/2"}, {"what", "search_ball"}});
  ASSERT_EQ(answer["ok"], true) << answer.dump();
  EXPECT_EQ(answer["alternative"]["kind"], "changed");
}

TEST_F(ReasonsService, AMomentIsASituationOfTheSimulator) {
  ASSERT_TRUE(body->step(1500));
  const json answer = call("/decision/situation", {{"robot", "14/2"}});
  ASSERT_EQ(answer["ok"], true) << answer.dump();
  const auto state = sim::io::parse_situation(answer["situation"].get<std::string>(), "it", tests::setup().params());
  ASSERT_TRUE(state) << state.error();
  EXPECT_EQ(call("/decision/situation", {{"robot", "99/1"}})["error"],
            "/decision/situation: robot '99/1' has not decided anything");
}

TEST_F(ReasonsService, ARobotThatHasNotDecidedGetsASentence) {
  EXPECT_EQ(call("/decision/why", {{"robot", "99/1"}})["error"],
            "/decision/why: robot '99/1' has not decided anything");
  EXPECT_EQ(call("/decision/why_not", {{"robot", "14/2"}})["error"],
            "/decision/why_not: 'what' must be a text of at most 1000 bytes");
}

}  // namespace
}  // namespace robot::app
