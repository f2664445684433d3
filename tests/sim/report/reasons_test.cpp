#include "sim/report/reasons.h"

#include <gtest/gtest.h>

#include <cmath>

#include "robot/core/json_library.h"
#include "sim/debug/setup.h"
#include "sim/debug/timeline.h"
#include "tests/sim/support/games.h"

namespace sim::report {
namespace {

using debug::SharedSetup, debug::Timeline, debug::Why;

struct Reasons : ::testing::Test {
  /// Explains decisions of all robots in a game, in and outside play.
  template <class See>
  void for_each_decision(See&& see) {
    for (Tick tick = 300; tick < 12'000; tick += 397)
      for_each_robot(setup->params.rules.players, [&](int robot) {
        const auto decision = debug::decision_before(timeline, tick, robot);
        if (!decision) return;
        const agent::TreeBehaviour& behaviour = *debug::tree_of(setup->params, robot);
        Why why = debug::why(setup->params, behaviour, *decision, timeline.at(decision->tick));
        find_sources(setup->params, behaviour.tree(), why);
        see(why, behaviour.tree());
      });
  }

  const SharedSetup setup = debug::prepare({}).value();
  Timeline timeline{setup, sim::test::begun(setup->params, 11)};
};

TEST_F(Reasons, TheTakenPartsLeadToTheLeafAndTheComparisonsToTheirParts) {
  int played = 0;
  for_each_decision([&](const Why& why, const agent::Tree& tree) {
    const Json json = to_json(why, tree, "14/2");
    EXPECT_EQ(json["skill"], why.skill);
    EXPECT_EQ(json["plays"], why.plays);
    if (!why.plays) {
      EXPECT_TRUE(json["parts"].empty());
      return;
    }
    ++played;
    std::string innermost;
    for (const Json& part : json["parts"])
      if (part["taken"] == true) {
        EXPECT_TRUE(tree.leaf_words[why.leaf].path.starts_with(part["path"].get<std::string>()));
        innermost = part["path"];
      }
    EXPECT_EQ(innermost, tree.leaf_words[why.leaf].path);
    EXPECT_EQ(json["comparisons"].size(), tree.nodes.size());
    for (const Json& comparison : json["comparisons"]) {
      const std::string& path = tree.node_words[comparison["node"].get<std::size_t>()].path;
      EXPECT_TRUE(json["parts"][comparison["part"].get<std::size_t>()]["path"].get<std::string>().starts_with(path));
    }
  });
  EXPECT_GT(played, 100);
}

TEST_F(Reasons, ThePathHoldsValueTruthMarginAndTheOtherLeaf) {
  int misled = 0;
  for_each_decision([&](const Why& why, const agent::Tree& tree) {
    const Json json = to_json(why, tree, "14/2");
    ASSERT_EQ(json["path"].size(), why.path.size());
    for (std::size_t i = 0; i < why.path.size(); ++i) {
      const debug::Reason& reason = why.path[i];
      const agent::Feature feature = tree.nodes[reason.node].feature;
      const Json& told = json["path"][i];
      EXPECT_EQ(told["value"], debug::value_text(feature, reason.answer.value));
      EXPECT_EQ(told["truth"], debug::value_text(feature, reason.truth));
      const agent::Node& node = tree.nodes[reason.node];
      EXPECT_EQ(told["misled"],
                agent::holds(node.comparison, reason.truth, reason.answer.threshold) != reason.answer.result);
      misled += told["misled"] == true;
      EXPECT_EQ(told["other"].is_null(), std::isnan(reason.flip.value));
      EXPECT_EQ(told["flip"].is_null(), std::isnan(reason.flip.value));
      if (!told["other"].is_null()) {
        EXPECT_EQ(told["other"]["leaf"], tree.leaf_words[reason.by_value].path);
      }
      EXPECT_EQ(told["sources"].size(), reason.sources.size());
    }
    EXPECT_EQ(json["narrowest"].is_null(), !why.narrowest.has_value());
  });
  EXPECT_GT(misled, 0);
}

TEST_F(Reasons, WithoutTruthNothingOfItIsTold) {
  for_each_decision([&](const Why& why, const agent::Tree& tree) {
    const Json json = to_json(why, tree, "14/2", false);
    for (const Json& reason : json["path"]) {
      EXPECT_TRUE(reason["truth"].is_null());
      EXPECT_EQ(reason["misled"], false);
      for (const Json& source : reason["sources"]) {
        EXPECT_TRUE(source["error"].is_null());
        EXPECT_EQ(source["text"].get<std::string>().find("off"), std::string::npos);
      }
    }
  });
}

TEST_F(Reasons, AnAlternativeIsToldAsItWasFound) {
  for_each_decision([&](const Why& why, const agent::Tree& tree) {
    if (!why.plays) return;
    const auto goal = debug::goal_of("search_ball", tree);
    const auto found = debug::alternative_to(setup->params, tree, why.decision, *goal, "14/2");
    ASSERT_TRUE(found);
    const Json json = to_json(*found, tree, "14/2", "search_ball");
    EXPECT_EQ(json["kind"], why.skill == "search_ball" ? "reached" : "changed");
    EXPECT_EQ(json["leaf"], tree.leaf_words[found->features.leaf].path);
    EXPECT_EQ(json["features"].size(), found->features.values.size());
    EXPECT_EQ(json["thresholds"].is_null(), !found->thresholds.has_value());
    EXPECT_EQ(json["beliefs"].is_null(), !found->beliefs.has_value());
    EXPECT_EQ(json["text"], text_of(*found, tree, "14/2", "search_ball"));
  });
}

}  // namespace
}  // namespace sim::report
