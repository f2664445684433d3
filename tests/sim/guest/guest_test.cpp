#include "sim/guest/guest.h"

#include <gtest/gtest.h>

#include "tests/sim/agent/scene.h"

namespace sim::guest {
namespace {

std::string charge_in_python() {
  return std::string("pipe:") + FORESIGHT_PYTHON + " " + FORESIGHT_EXAMPLES + "/charge.py";
}

std::shared_ptr<const GuestFactory> opened(const std::string& name) {
  auto source = open(name);
  EXPECT_TRUE(source) << source.error();
  return source ? *source : nullptr;
}

std::string refusal(const std::string& name) {
  const auto source = open(name);
  return source ? "it was taken" : source.error();
}

std::string library(const std::string& name) { return std::string(FORESIGHT_LIBRARIES) + "/guest_" + name + ".so"; }

TEST(GuestBehaviour, IsKnownByItsName) {
  EXPECT_TRUE(is_guest("./mine.so") && is_guest("mine.so") && is_guest("pipe:python3 mine.py"));
  EXPECT_FALSE(is_guest("baseline") || is_guest("mine.json") || is_guest("baseline,near_ball=0.3"));
}

TEST(GuestBehaviour, AForeignLibraryIsRefusedWithASentence) {
  const auto says = [](const std::string& name, const std::string& what) {
    EXPECT_EQ(refusal(library(name)).find("behaviour '" + library(name) + "': " + what), 0u) << refusal(library(name));
  };
  says("missing", "cannot be loaded: ");
  says("no_entry", "exports no foresight_behaviour, see sim/guest/foresight_behaviour.h");
  says("old_version", "expected version 1 of the interface, got 0; build it anew");
  says("other_size", "expected structs of ");
  says("no_decide", "expected create, destroy and decide, got a null pointer");
  says("save_alone", "expected save and load, or neither, got one of them");
}

TEST(GuestBehaviour, AProcessThatDoesNotAnswerIsRefusedWithASentence) {
  EXPECT_EQ(refusal("pipe: "), "behaviour 'pipe: ': expected a command behind pipe:");
  EXPECT_EQ(refusal("pipe:sh -c 'exit 3'"),
            "behaviour 'pipe:sh -c 'exit 3'': the process ended with status 3 instead of answering");
  EXPECT_NE(refusal("pipe:echo hello").find("expected a JSON object as answer, got 'hello'"), std::string::npos);
}

/// Asks a behaviour about moments in turn, and returns its commands.
std::vector<motion::Command> decisions_of(GuestBehaviour& guest, int count) {
  std::mt19937 random(5);
  std::vector<motion::Command> commands;
  agent::Mind minds[kMaxPlayers + 1];
  for (int i = 0; i < count; ++i) {
    agent::Scene scene = agent::random_scene(random);
    scene.mind = minds[scene.game.player];
    commands.push_back(scene.decide(guest));
    minds[scene.game.player] = scene.mind;
  }
  return commands;
}

TEST(GuestBehaviour, TheSameExampleInCAndInPythonDecidesTheSame) {
  const auto in_c = opened(FORESIGHT_CHARGE)->begin(1), in_python = opened(charge_in_python())->begin(1);
  const auto c = decisions_of(*in_c, 300), python = decisions_of(*in_python, 300);
  EXPECT_EQ(in_c->problem() + in_python->problem(), "");
  for (std::size_t i = 0; i < c.size(); ++i) {
    EXPECT_EQ(c[i].body, python[i].body) << i;
    // C computes in floats, Python in doubles
    EXPECT_NEAR(c[i].walk.x, python[i].walk.x, 1e-4) << i;
    EXPECT_NEAR(c[i].walk.y, python[i].walk.y, 1e-4) << i;
  }
}

TEST(GuestBehaviour, IsAFunctionOfItsInput) {
  for (const std::string& name : {std::string(FORESIGHT_CHARGE), charge_in_python()}) {
    const auto source = opened(name);
    EXPECT_EQ(decisions_of(*source->begin(7), 100), decisions_of(*source->begin(7), 100)) << name;
  }
}

TEST(GuestBehaviour, ASavedMemoryIsLoaded) {
  const auto source = opened(FORESIGHT_CHARGE);
  ASSERT_TRUE(source->saves());
  const auto guest = source->begin(1);
  decisions_of(*guest, 50);
  const auto memory = guest->save();
  ASSERT_TRUE(memory);
  const auto after = decisions_of(*guest, 50);
  ASSERT_TRUE(guest->load(*memory));
  EXPECT_EQ(guest->save(), memory);
  const auto fresh = source->begin(1);
  ASSERT_TRUE(fresh->load(*memory));
  EXPECT_EQ(fresh->save(), memory) << "its players are made at their first decisions";
  EXPECT_EQ(decisions_of(*guest, 50), after);
  for (std::size_t n = 0; n < memory->size(); ++n) EXPECT_FALSE(guest->load(memory->substr(0, n))) << n;
  EXPECT_FALSE(opened(charge_in_python())->begin(1)->save());
}

TEST(GuestBehaviour, StandsAfterAnErrorAndReportsIt) {
  // a correct greeting, then wrong answers
  const std::string name = R"(pipe:sh -c 'read x; echo "{\"version\": 1}"; read x; echo "{\"body\": \"fly\"}"')";
  const auto guest = opened(name)->begin(1);
  agent::Scene scene;
  scene.see_ball({1, 0});
  EXPECT_EQ(scene.decide(*guest).body, motion::Command::Body::stand);
  EXPECT_EQ(guest->problem(),
            "behaviour '" + name +
                "': player 2, tick 3000: body must be one of usual, stand, walk_speed, walk_to, kick, "
                "squat, got \"fly\"");
  EXPECT_EQ(scene.decide(*guest).body, motion::Command::Body::stand);
}

TEST(GuestBehaviour, ItsContentIsThatOfTheNamedFiles) {
  EXPECT_NE(content_of(FORESIGHT_CHARGE), content_of(library("no_entry")));
  EXPECT_EQ(content_of(charge_in_python()), content_of(charge_in_python()));
  EXPECT_NE(content_of(charge_in_python()), content_of("pipe:" + std::string(FORESIGHT_PYTHON)));
}

}  // namespace
}  // namespace sim::guest
