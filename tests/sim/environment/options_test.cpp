#include "sim/environment/options.h"

#include <gtest/gtest.h>

#include <fstream>

#include "tests/support/temporary_folder.h"

namespace sim::environment {
namespace {

std::string refusal(const std::string& text) {
  const auto options = read_options(text);
  return options ? "accepted" : options.error();
}

TEST(Options, AreThoseOfTheHeaderWhenNotGiven) {
  const auto options = read_options("{}");
  ASSERT_TRUE(options) << options.error();
  EXPECT_EQ(options->games, 1);
  EXPECT_EQ(options->ticks, 3);
  EXPECT_TRUE(options->restarts);
  EXPECT_TRUE(options->controlled[0]);
  EXPECT_FALSE(options->controlled[1]);
  EXPECT_EQ(options->actions, Kind::menu);
  EXPECT_FALSE(options->has_start);
  EXPECT_EQ(options->drill.duration, kNever);
  EXPECT_EQ(options->drill.game.rules, "spl2012");
  EXPECT_EQ(options->drill.game.pace, Pace::thinned);
  EXPECT_EQ(options->frame.tree.menu.size(), 12u);
  EXPECT_EQ(options->frame.columns.count(), agent::Columns(agent::built_in_features()).count());
}

TEST(Options, OfTheGameReplaceThoseOfTheDrill) {
  const auto options = read_options(R"({"drill": "corner", "rules": "spl2025:5", "away": "idle", "seconds": 7,
    "control": "both", "every_tick": true, "restart": "never", "models": "perfect"})");
  ASSERT_TRUE(options) << options.error();
  EXPECT_TRUE(options->has_start);
  EXPECT_EQ(options->drill.game.rules, "spl2025:5");
  EXPECT_EQ(options->drill.game.strategies[0], "baseline");
  EXPECT_EQ(options->drill.game.strategies[1], "idle");
  EXPECT_EQ(options->drill.game.models[1], "perfect");
  EXPECT_EQ(options->drill.duration, ticks(7));
  EXPECT_EQ(options->drill.game.pace, Pace::every_tick);
  EXPECT_TRUE(options->controlled[1]);
  EXPECT_FALSE(options->restarts);
}

TEST(Options, AFrameMayBeAFile) {
  const tests::TemporaryFolder folder;
  const std::string path = (folder.path() / "frame.json").string();
  std::ofstream(path) << R"({"name": "x", "menu": [{"do": "kick"}, {"do": "stand"}], "inputs": ["ball_distance"]})";
  const auto options = read_options(R"({"frame": ")" + path + R"("})");
  ASSERT_TRUE(options) << options.error();
  EXPECT_EQ(options->frame.tree.menu.size(), 2u);
  EXPECT_EQ(options->frame.columns.count(), 1);
}

TEST(Options, AnErrorIsASentenceWithThePlace) {
  EXPECT_EQ(refusal(R"({"ticks": 0})"), "environment: ticks must be a whole number, 1 .. 3000, got 0");
  EXPECT_EQ(refusal(R"({"game": 1})"), "environment: game is unknown; did you mean 'games'?");
  EXPECT_EQ(refusal(R"({"control": "us"})"), "environment: control must be one of home, away, both, got \"us\"");
  EXPECT_EQ(refusal(R"({"drill": 7})"), "environment: drill must be a text, got 7");
  EXPECT_EQ(refusal(R"({"frame": 7})"), "environment: frame must be an object or a file, got 7");
  EXPECT_EQ(refusal(R"({"frame": {"name": "x", "menu": [{"do": "kik"}]}})"),
            "environment: frame: menu[0].do: no skill \"kik\"; did you mean 'kick'?");
  EXPECT_EQ(refusal(R"({"drill": "cornr"})"), "no drill 'cornr'; did you mean 'corner'?");
}

TEST(Options, SurviveEveryTruncation) {
  const std::string text = R"({"games": 3, "drill": "corner", "frame": {"name": "x", "menu": [{"do": "kick"}]}})";
  for (std::size_t n = 0; n < text.size(); ++n) EXPECT_FALSE(read_options(text.substr(0, n))) << n;
}

}  // namespace
}  // namespace sim::environment
