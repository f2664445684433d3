#include "sim/io/policy.h"

#include <gtest/gtest.h>

#include <fstream>

#include "robot/core/json_library.h"
#include "sim/io/chooser.h"
#include "sim/match/hash.h"
#include "sim/match/play.h"
#include "tests/sim/support/games.h"
#include "tests/support/temporary_folder.h"

namespace sim::io {
namespace {

constexpr const char* kPolicy = R"({
  "name": "mine", "based_on": "baseline",
  "menu": [{"do": "kick"}, {"use": "chaser"}],
  "inputs": ["ball_distance", "ball_bearing"],
  "net": {"layers": [
    {"weights": [[1, 2], [3, 4], [5, 6]], "bias": [0, 0, 0], "activation": "tanh"},
    {"weights": [[1, 0, 1], [0, 1, 0]], "bias": [0.5, 0]}]}
})";

/// Returns the error of kPolicy with one entry replaced.
std::string refusal(const std::string& pointer, const Json& value) {
  Json json = Json::parse(kPolicy);
  json[Json::json_pointer(pointer)] = value;
  const auto policy = parse_policy(json.dump(), "strategy 'mine'");
  return policy ? "accepted" : policy.error();
}

TEST(Policy, HasARowOfWeightsPerOutput) {
  const auto policy = parse_policy(kPolicy, "strategy 'mine'");
  ASSERT_TRUE(policy) << policy.error();
  const agent::Layer& first = policy->net().layers[0];
  EXPECT_EQ(first.inputs, 2);
  EXPECT_EQ(first.outputs, 3);
  EXPECT_EQ(first.weights, (std::vector<float>{1, 3, 5, 2, 4, 6}));
  EXPECT_EQ(first.activation, agent::Activation::tanh);
  EXPECT_EQ(policy->net().layers[1].activation, agent::Activation::none);
}

TEST(Policy, WithoutInputsItSeesAllBuiltInFeatures) {
  Json json = Json::parse(kPolicy);
  json.erase("inputs"), json.erase("net");
  const auto frame = read_frame(json, "frame");
  ASSERT_TRUE(frame) << frame.error();
  EXPECT_EQ(frame->columns.count(), agent::Columns(agent::built_in_features()).count());
  EXPECT_EQ(frame->tree.menu.size(), 2u);
}

TEST(Policy, AnErrorNamesThePlace) {
  const std::string called = "strategy 'mine': ";
  EXPECT_EQ(refusal("/net/layers/0/bias", {1, 2}),
            called + "net.layers[0].bias must be a list of 3 numbers, got one of 2");
  EXPECT_EQ(refusal("/net/layers/0/weights/1", {1, 2, 3}),
            called + "net.layers[0].weights[1] must be a list of 2 numbers, got one of 3");
  EXPECT_EQ(refusal("/net/layers/0/weights/1/0", 1e9),
            called + "net.layers[0].weights[1] must have numbers from -1e6 to 1e6, got 1000000000.0");
  EXPECT_EQ(refusal("/net/layers/0/activation", "sigmoid"),
            called + "net.layers[0].activation must be one of none, relu, tanh, got \"sigmoid\"");
  EXPECT_EQ(refusal("/menu", {{{"do", "kick"}}}),
            called + "the last layer must have 1 outputs, one per rule of the menu, got 2");
  EXPECT_EQ(refusal("/menu", Json::array()), called + "menu must be a list of 1 .. 64 rules, got []");
  EXPECT_EQ(refusal("/menu/0", {{"if", "ball_known"}, {"do", "kick"}}),
            called + "menu[0]: has no 'else', and no later rule applies when 'ball_known' fails");
  EXPECT_EQ(refusal("/inputs/1", "ball_distance"), called + "inputs[1] names \"ball_distance\" twice");
  EXPECT_EQ(refusal("/inputs/1", "ball_distanc"),
            called + "inputs[1]: no feature \"ball_distanc\"; did you mean 'ball_distance'?");
  EXPECT_EQ(refusal("/net", nullptr), called + "net must be an object, got null");
  EXPECT_EQ(refusal("/tree", {{"do", "kick"}}).substr(0, 34), called + "tree is unknown; ");
}

TEST(Policy, SurvivesEveryTruncation) {
  const std::string text = kPolicy;
  for (std::size_t n = 0; n < text.size(); ++n) EXPECT_FALSE(parse_policy(text.substr(0, n), "strategy 'cut'")) << n;
}

TEST(Policy, IsABehaviourByTheNameOfItsFile) {
  const tests::TemporaryFolder folder;
  const std::string path = (folder.path() / "mine.json").string();
  std::ofstream(path) << kPolicy;
  const auto behaviour = load_behaviour(path, {}, Side::home);
  ASSERT_TRUE(behaviour) << behaviour.error();
  EXPECT_EQ((*behaviour)->name(), "mine");
  EXPECT_EQ(load_behaviour(path + ",near=1", {}, Side::home).error(),
            "strategy '" + path + ",near=1': a learned policy takes no changes behind its name");

  // it plays, and the same seed is the same game
  const auto game = test::setup_of({.strategies = {path, "baseline"}}, 60);
  State first = test::begun(game.params, 3), second = first;
  play_on(game.params, first), play_on(game.params, second);
  EXPECT_EQ(hash_of(first), hash_of(second));
}

TEST(Policy, MustNotNameAKickThatTheModelsLack) {
  Json json = Json::parse(kPolicy);
  json["menu"][0]["with"] = {{"kick", "sid"}};
  const tests::TemporaryFolder folder;
  const std::string path = (folder.path() / "mine.json").string();
  std::ofstream(path) << json.dump();
  const auto behaviour = load_behaviour(path, {}, Side::home);
  ASSERT_FALSE(behaviour);
  EXPECT_EQ(behaviour.error(), "strategy 'mine': models 'match' have no kick \"sid\"; did you mean 'side'?");
}

}  // namespace
}  // namespace sim::io
