#include "sim/io/strategy.h"

#include <gtest/gtest.h>

#include <cmath>
#include <random>

#include "sim/io/models.h"
#include "sim/io/source.h"

namespace sim::io {
namespace {

using agent::Skill;

std::string refusal(const std::string& text) {
  const auto tree = parse_strategy(text, "strategy 'mine'");
  return tree ? "accepted" : tree.error();
}
/// Returns the error of a strategy that has only a tree.
std::string refusal_of_tree(const std::string& tree) { return refusal(R"({"name": "mine", "tree": )" + tree + "}"); }

TEST(Strategy, EachShippedStrategyLoadsByItsName) {
  const auto names = names_of("strategies");
  EXPECT_EQ(listed(names), "align_first, all_kicks, baseline, high_line, idle, kick_now, learned, passing");
  for (const std::string_view name : names) {
    const auto behaviour = load_strategy(std::string(name));
    ASSERT_TRUE(behaviour) << behaviour.error();
    EXPECT_EQ((*behaviour)->name(), name);
    EXPECT_NE((*behaviour)->tree().about, "");
  }
}

TEST(Strategy, MayVaryParameters) {
  const auto plain = load_strategy("baseline"), varied = load_strategy("baseline,near_goal=2.5");
  ASSERT_TRUE(plain && varied);
  EXPECT_EQ((*varied)->name(), "baseline,near_goal=2.5");
  int differences = 0;
  for (std::size_t i = 0; i < (*plain)->tree().nodes.size(); ++i)
    differences += (*plain)->tree().nodes[i].threshold != (*varied)->tree().nodes[i].threshold;
  EXPECT_EQ(differences, 1);
  EXPECT_EQ(load_strategy("baseline,near_bal=0.6").error(),
            "strategy 'baseline,near_bal=0.6': parameters.near_bal: is not used; did you mean 'near_ball'?");
}

TEST(Strategy, MissingEntriesComeFromTheBase) {
  const auto tree = parse_strategy(
      R"({"name": "mine", "based_on": "baseline", "roles": {"defenders": 1}, "subtrees": {"keeper": {"do": "stand"}}})",
      "strategy 'mine'");
  ASSERT_TRUE(tree) << tree.error();
  EXPECT_EQ(tree->settings.roles.defenders, 1);
  EXPECT_EQ(tree->settings.roles.hysteresis, load_strategy("baseline").value()->tree().settings.roles.hysteresis);
  int stands = 0;
  for (const agent::Leaf& leaf : tree->leaves) stands += leaf.skill == agent::find_skill("stand");
  EXPECT_EQ(stands, 1);
}

TEST(Strategy, ValuesMayHaveUnits) {
  const auto tree = parse_strategy(R"({"name": "m", "parameters": {"far": "50 cm", "aim": "goal"}, "tree": [
    {"if": "ball_bearing > -90 deg and ball_age < 0.5min and ball_distance < $far", "do": "stand"},
    {"do": "walk_to_ball", "with": {"aim": "$aim", "distance": "$far", "tolerance": "180 deg", "gain": 0.5}}]})",
                                   "strategy 'm'");
  EXPECT_EQ(tree ? "" : tree.error(), "strategy 'm': tree[1].with.tolerance: must be 0.01 .. 3 [rad], got \"180 deg\"");
}

TEST(Strategy, AFailedConditionLeadsToTheNextRuleOrToElse) {
  const auto tree = parse_strategy(R"({"name": "m", "tree": [
    {"if": "our_kick", "then": [{"if": "x < 0", "do": "block"}]},
    {"if": "half is 2", "do": "stand"},
    {"do": "look_round"}]})",
                                   "strategy 'm'");
  EXPECT_EQ(tree ? "" : tree.error(), "strategy 'm': tree[1].if: half is compared by < <= > >=, got \"half is 2\"");
  const auto good = parse_strategy(R"({"name": "m", "tree": [
    {"if": "our_kick", "then": [{"if": "x < 0", "do": "block"}]},
    {"if": "y < 0 or set_play is not none", "do": "stand"},
    {"do": "look_round"}]})",
                                   "strategy 'm'");
  ASSERT_TRUE(good) << good.error();
  // "x < 0" and "our_kick" lead to the same place when they fail
  const auto& nodes = good->nodes;
  ASSERT_EQ(nodes.size(), 4u);
  const agent::Node& root = nodes[good->root];
  EXPECT_EQ(root.feature, agent::find_feature("our_kick"));
  EXPECT_EQ(nodes[root.yes].no, root.no);
  EXPECT_EQ(good->leaves[nodes[root.yes].yes & ~agent::kLeafBit].skill, agent::find_skill("block"));
  EXPECT_EQ(nodes[root.no].feature, agent::find_feature("y"));
  EXPECT_EQ(nodes[nodes[root.no].no].yes, nodes[root.no].yes);
}

TEST(Strategy, BadTreesAreRefusedWithPlaceAndReason) {
  EXPECT_EQ(refusal("[]"), "strategy 'mine': expected a JSON object, got []");
  EXPECT_EQ(refusal(R"({"name": "mine"})"), "strategy 'mine': tree is missing");
  EXPECT_EQ(refusal(R"({"tree": {"do": "stand"}})"), "strategy 'mine': name must have 1 .. 60 bytes");
  EXPECT_EQ(refusal_of_tree("7"), "strategy 'mine': tree: must be a rule or a list of rules, got 7");
  EXPECT_EQ(refusal_of_tree("[]"), "strategy 'mine': tree: must have at least one rule");
  EXPECT_EQ(refusal_of_tree(R"({"do": "fly"})").substr(0, 44), "strategy 'mine': tree.do: no skill \"fly\"; th");
  EXPECT_EQ(refusal_of_tree(R"({"do": "kik"})"), "strategy 'mine': tree.do: no skill \"kik\"; did you mean 'kick'?");
  EXPECT_EQ(refusal_of_tree(R"({"do": "kick", "width": {}})"),
            "strategy 'mine': tree: no rule has 'width'; did you mean 'with'?");
  EXPECT_EQ(refusal_of_tree(R"({"do": "kick", "with": {"aims": "goal"}})"),
            "strategy 'mine': tree.with: kick takes no 'aims'; did you mean 'aim'?");
  EXPECT_EQ(refusal_of_tree(R"({"do": "kick", "with": {"aim": "gaol"}})"),
            "strategy 'mine': tree.with.aim: must be one of goal, opening, ahead, away, mate, cross, got \"gaol\"");
  EXPECT_EQ(refusal_of_tree(R"({"do": "kick", "with": {"range": 40}})"),
            "strategy 'mine': tree.with.range: must be 0 .. 12 [m], got 40");
  EXPECT_EQ(refusal_of_tree(R"({"do": "kick", "with": {"range": "2 s"}})"),
            "strategy 'mine': tree.with.range: must be in m, got \"2 s\"");
  EXPECT_EQ(refusal_of_tree(R"({"do": "kick", "with": {"range": true}})"),
            "strategy 'mine': tree.with.range: must be 0 .. 12 [m], got true");
  EXPECT_EQ(refusal_of_tree(R"({"if": "bal_age < 3", "do": "stand"})"),
            "strategy 'mine': tree.if: no feature \"bal_age\"; did you mean 'ball_age'?");
  EXPECT_EQ(refusal_of_tree(R"({"if": "ball_age < 3", "do": "stand"})"),
            "strategy 'mine': tree: has no 'else', and no later rule applies when 'ball_age < 3' fails");
  EXPECT_EQ(refusal_of_tree(R"({"if": "ball_age < -3 s", "do": "stand"})"),
            "strategy 'mine': tree.if: the value for ball_age must be 0 .. 1000 [s], got \"-3 s\"");
  EXPECT_EQ(refusal_of_tree(R"({"if": "ball_age", "do": "stand"})"),
            "strategy 'mine': tree.if: ball_age must be compared with a value, got \"ball_age\"");
  EXPECT_EQ(refusal_of_tree(R"({"if": "ball_known > 0", "do": "stand"})"),
            "strategy 'mine': tree.if: ball_known is yes or no and must stand alone, got \"ball_known > 0\"");
  EXPECT_EQ(refusal_of_tree(R"({"if": "role is striker", "do": "stand"})"),
            "strategy 'mine': tree.if: the value for role must be one of keeper, chaser, supporter, defender, "
            "got \"striker\"");
  EXPECT_EQ(refusal_of_tree(R"({"if": "role < 2", "do": "stand"})"),
            "strategy 'mine': tree.if: role is compared by is, is not, got \"role < 2\"");
  EXPECT_EQ(refusal_of_tree(R"({"if": "x > 0 and  and y > 0", "do": "stand"})"),
            "strategy 'mine': tree.if: a comparison is missing");
  EXPECT_EQ(refusal_of_tree(R"({"if": "x > $far", "do": "stand"})"),
            "strategy 'mine': tree.if: the value for x names no parameter: \"far\"; there are none");
  EXPECT_EQ(refusal_of_tree(R"({"if": "x > 0", "do": "stand", "then": {}})"),
            "strategy 'mine': tree: must have one of 'do', 'use' and 'then'");
  EXPECT_EQ(refusal_of_tree(R"([{"do": "stand"}, {"do": "kick"}])"),
            "strategy 'mine': tree[1]: is never reached, the rule before always decides");
  EXPECT_EQ(refusal_of_tree(R"({"use": "chaser"})"), "strategy 'mine': tree.use: no subtree 'chaser'; there are none");
}

TEST(Strategy, CyclesAndUnusedEntriesAreRefused) {
  EXPECT_EQ(refusal(R"({"name": "m", "tree": {"use": "a"}, "subtrees": {"a": {"use": "b"}, "b": [{"use": "a"}]}})"),
            "strategy 'mine': subtrees.b[0].use: the subtree 'a' leads back to itself");
  EXPECT_EQ(refusal(R"({"name": "m", "tree": {"do": "stand"}, "subtrees": {"a": {"do": "stand"}}})"),
            "strategy 'mine': subtrees.a: is not used");
  EXPECT_EQ(refusal(R"({"name": "m", "tree": {"do": "stand"}, "parameters": {"a": 1}})"),
            "strategy 'mine': parameters.a: is not used");
  EXPECT_EQ(refusal(R"({"name": "m", "tree": {"do": "kick", "with": {"range": "$a"}}, "parameters": {"a": "$a"}})"),
            "strategy 'mine': tree.with.range: is the parameter \"a\", which must be a value, got \"$a\"");
  EXPECT_EQ(refusal(R"({"name": "m", "tree": {"do": "kick", "with": {"range": "$a"}}, "parameters": {"a": 99}})"),
            "strategy 'mine': tree.with.range: is the parameter \"a\", which must be 0 .. 12 [m], got 99");
  EXPECT_EQ(refusal(R"({"name": "m", "based_on": "besaline"})"),
            "strategy 'mine': based_on: no strategy 'besaline'; did you mean 'baseline'?");
  EXPECT_EQ(refusal(R"({"name": "m", "tree": {"do": "stand"}, "formation": {"ours": [[0.5, 0]]}})"),
            "strategy 'mine': formation.ours[0] must be [-1 .. 0, -1 .. 1], got [0.5,0]");
  EXPECT_EQ(refusal(R"({"name": "m", "tree": {"do": "stand"}, "roles": {"hysteresis": -1}})"),
            "strategy 'mine': roles.hysteresis must be 0 .. 20 [s], got -1");
}

TEST(Strategy, TreesTooDeepOrTooLargeAreRefused) {
  std::string deep = R"({"do": "stand"})";
  for (int i = 0; i < 30; ++i) deep = R"({"if": "x > 0", "do": "stand", "else": )" + deep + "}";
  EXPECT_EQ(refusal_of_tree(deep), "accepted");
  for (int i = 0; i < 20; ++i) deep = R"({"if": "x > 0", "do": "stand", "else": )" + deep + "}";
  EXPECT_NE(refusal_of_tree(deep).find("rules are nested too deeply"), std::string::npos);

  // each subtree uses the next one twice
  std::string doubling = R"({"name": "m", "tree": {"use": "s0"}, "subtrees": {)";
  for (int i = 0; i < 20; ++i) {
    const std::string next = R"({"use": "s)" + std::to_string(i + 1) + "\"}";
    doubling += "\"s" + std::to_string(i) + R"(": {"if": "x > 0", "then": )" + next + R"(, "else": )" + next + "},";
  }
  doubling += R"("s20": {"do": "stand"}}})";
  EXPECT_EQ(refusal(doubling), "strategy 'mine': subtrees.s20: the tree is too large");
}

TEST(Strategy, SurvivesEveryTruncationAndFlippedBytes) {
  const std::string text = find_source("strategies", "strategy", "passing").value().text;
  for (std::size_t n = 0; n + 2 < text.size(); ++n) EXPECT_NE(refusal(text.substr(0, n)), "accepted");
  std::mt19937 random(1);
  const std::string base = find_source("strategies", "strategy", "baseline").value().text;
  int refused = 0;
  for (int n = 0; n < 300; ++n) {
    std::string flipped = base;
    flipped[random() % flipped.size()] = static_cast<char>(random());
    refused += refusal(flipped) != "accepted";
  }
  EXPECT_GT(refused, 100);
}

TEST(Strategy, ALeafNamesADirectionOrAPointInsteadOfTheAim) {
  const auto tree = parse_strategy(
      R"({"name": "mine", "parameters": {"x": "2 m"},
          "tree": [{"if": "ball_known", "do": "kick", "with": {"target": ["$x", -0.5]}},
                   {"do": "pass", "with": {"direction": "90 deg"}}]})",
      "strategy 'mine'");
  ASSERT_TRUE(tree) << tree.error();
  const auto argument = [&](std::size_t leaf, const std::string& name) {
    const agent::SkillInfo& info = info_of(tree->leaves[leaf].skill);
    for (int i = 0; i < info.count; ++i)
      if (info.parameters[i].name == name) return tree->leaves[leaf].arguments[i];
    ADD_FAILURE() << name;
    return 0.f;
  };
  // leaves are numbered from the last rule on
  EXPECT_EQ(argument(1, "target_x"), 2);
  EXPECT_EQ(argument(1, "target_y"), -0.5f);
  EXPECT_FALSE(agent::is_given(argument(1, "direction")));
  EXPECT_NEAR(argument(0, "direction"), 1.5708f, 1e-4f);
  EXPECT_FALSE(agent::is_given(argument(0, "target_x")));

  const auto kick = [](const std::string& with) {
    return refusal_of_tree(R"({"do": "kick", "with": {)" + with + "}}");
  };
  EXPECT_EQ(kick(R"("aim": "goal", "direction": "10 deg")"),
            "strategy 'mine': tree.with: takes 'aim' or 'direction', got both");
  EXPECT_EQ(kick(R"("direction": 1, "target": [1, 2])"),
            "strategy 'mine': tree.with: takes 'direction' or 'target', got both");
  EXPECT_EQ(kick(R"("target": [1, 2, 3])"),
            "strategy 'mine': tree.with.target: must be a point [x, y] in m, got [1,2,3]");
  EXPECT_EQ(kick(R"("target": [1, 20])"), "strategy 'mine': tree.with.target_y: must be -6 .. 6 [m], got 20");
  EXPECT_EQ(kick(R"("target_x": 1)").substr(0, 58), "strategy 'mine': tree.with: kick takes no 'target_x'; did ");
}

TEST(Strategy, NamesOfKicksAreCheckedAgainstTheModelsOfTheGame) {
  const auto tree = parse_strategy(R"({"name": "mine", "parameters": {"with": "sid"},
                                       "tree": [{"if": "ball_known", "do": "kick", "with": {"kick": "$with"}},
                                                {"if": "ball_age < 1", "do": "kick", "with": {"kick": "any"}},
                                                {"do": "align", "with": {"kick": "long"}}]})",
                                   "strategy 'mine'");
  ASSERT_TRUE(tree) << tree.error();
  EXPECT_EQ(tree->settings.kicks.count, 2);
  Team team;
  ASSERT_TRUE(load_team_models("match+3=perfect", 5, team));
  EXPECT_EQ(check_kicks(*tree, team).error(),
            "strategy 'mine': models 'match+3=perfect' have no kick \"sid\"; did you mean 'side'?");
  agent::Tree right = *tree;
  right.settings.kicks.count = 1;
  EXPECT_TRUE(check_kicks(right, team));
  EXPECT_EQ(
      refusal_of_tree(R"({"do": "kick", "with": {"kick": "a kick with a long name"}})"),
      "strategy 'mine': tree.with.kick: must be front, any or a kick's name of 1 .. 15 bytes, got \"a kick with a "
      "long name\"");
}

}  // namespace
}  // namespace sim::io
