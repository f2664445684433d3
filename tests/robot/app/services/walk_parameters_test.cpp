#include "robot/app/services/walk_parameters.h"

#include <gtest/gtest.h>

#include <cmath>
#include <iterator>
#include <memory>
#include <string>
#include <vector>

#include "proto/foresight/live_parameters.pb.h"
#include "robot/app/services/live_parameter_service.h"
#include "robot/nao/walk/named_parameters.h"

namespace robot::app {
namespace {

namespace walk = nao::walk;

struct WalkParameters : ::testing::Test {
  void SetUp() override {
    auto opened = LiveParameterService::open(table, "14/2", channels, clock);
    ASSERT_TRUE(opened) << opened.error();
    service = std::move(*opened);
    settings.lift = 0.025;
    ASSERT_TRUE(add_walk_parameters(table, settings, "14/2", channels, clock,
                                    [this](const walk::Parameters& all) { changes.push_back(all); }));
  }

  ManualClock clock{5 * kSecond};
  memory::Channels channels;
  net::Parameters table;
  std::unique_ptr<LiveParameterService> service;
  walk::Parameters settings;
  std::vector<walk::Parameters> changes;
};

TEST_F(WalkParameters, AreAllOfferedWithRangeUnitAndMeaning) {
  foresight::LiveParameters told;
  ASSERT_TRUE(told.ParseFromString(std::string(channels.find("/14/2/live_parameters")->newest()->bytes())));
  EXPECT_EQ(told.problem_size(), 0);
  ASSERT_EQ(told.parameter_size(), static_cast<int>(std::size(walk::kNamedParameters)));
  int at = 0;
  for (const walk::NamedParameter& named : walk::kNamedParameters) {
    const foresight::LiveParameter& parameter = told.parameter(at++);
    const double usual = walk::Parameters{}.*named.place;
    EXPECT_EQ(parameter.name(), "walk." + std::string(named.name));
    EXPECT_EQ(parameter.number(), settings.*named.place);
    EXPECT_EQ(parameter.initial_number(), settings.*named.place);
    EXPECT_EQ(parameter.min(), usual / 4);
    EXPECT_EQ(parameter.max(), usual * 4);
    EXPECT_EQ(parameter.unit(), named.unit == "0..1" ? "" : named.unit);
    EXPECT_EQ(parameter.description().size(), named.meaning.size() + 1);
  }
  EXPECT_EQ(told.parameter(1).description(), "Height of the hip above the soles.");
  EXPECT_TRUE(changes.empty()) << "nobody has changed one";
}

TEST_F(WalkParameters, AChangeGivesAllOfThemToTheWalk) {
  ASSERT_TRUE(table.set("walk.period", 0.3));
  ASSERT_EQ(changes.size(), 1u);
  ASSERT_TRUE(table.set("walk.stand_side", 0.05));
  walk::Parameters expected = settings;
  expected.period = 0.3, expected.stand_side = 0.05;
  for (const walk::NamedParameter& named : walk::kNamedParameters)
    EXPECT_EQ(changes.back().*named.place, expected.*named.place) << named.name;
}

TEST_F(WalkParameters, AValueOutsideOfItsRangeChangesNothing) {
  for (const double wrong : {0.01, 2.0, std::nan("")}) EXPECT_FALSE(table.set("walk.period", wrong));
  EXPECT_FALSE(table.set("walk.no_such", 1.0));
  table.declare("other", 1.0);
  EXPECT_TRUE(table.set("other", 2.0));
  EXPECT_TRUE(changes.empty());
}

TEST_F(WalkParameters, ATakenTopicIsAnError) {
  const auto again = add_walk_parameters(table, settings, "14/2", channels, clock, [](const walk::Parameters&) {});
  ASSERT_FALSE(again);
  EXPECT_NE(again.error().find("/14/2/live_parameters/walk"), std::string::npos) << again.error();
}

}  // namespace
}  // namespace robot::app
