#include "sim/learn/learning.h"

#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <optional>
#include <thread>
#include <vector>

#include "robot/core/files.h"
#include "robot/core/json_library.h"
#include "sim/io/strategy.h"
#include "sim/learn/growing.h"
#include "sim/learn/tuning.h"
#include "tests/support/temporary_folder.h"

namespace sim::learn {
namespace {

// a clumsy striker: it kicks in any direction, and close to the goal it stands
constexpr const char* kClumsy = R"({
  "name": "clumsy",
  "parameters": {"tolerance": {"value": "160 deg", "learn": [5, 170]}},
  "tree": [
    {"if": "not ball_known", "do": "search_ball"},
    {"name": "far", "if": "ball_distance > 0.4", "do": "walk_to_ball"},
    {"name": "near the goal", "if": "ball_goal_distance < 3", "do": "stand"},
    {"do": "kick", "with": {"range": "5 m", "tolerance": "$tolerance"}}
  ]
})";

Layer striker() {
  return *parse_layer(R"({"skills": ["kick", "stand"], "conditions": ["ball_goal_distance", "line_error"],
                          "actions": [{"do": "kick", "with": {"range": "5 m"}}], "exercises": {"empty_goal": 1}})",
                      "layer", "striker");
}

class Striker : public testing::Test {
 protected:
  Ledger ledger_;
  Seeds seeds_{3};
  Arena arena_ = *Arena::prepare(striker().exercises, {.threads = 2}, ledger_);
  io::Json start_ = *io::flattened(kClumsy, "strategy 'clumsy'");
  Practice practice_{arena_, seeds_, [](const std::string&, double) {}, false};
};

TEST_F(Striker, LearnsAnotherActionWhereItStood) {
  const auto grown = grow(start_, striker(), {.attempts = 120, .selection = 200, .most = 3}, practice_);
  ASSERT_TRUE(grown) << grown.error();
  ASSERT_FALSE(grown->changes.empty());
  const std::string line = text_of(grown->changes[0]);
  EXPECT_NE(line.find("near the goal: stand → kick (range 5 m)"), std::string::npos) << line;
  const auto scores = *arena_.play(std::vector{start_, grown->strategy}, 99'000, 200);
  EXPECT_TRUE(is_sure(arena_.gain_of(scores[0], scores[1])));
}

TEST_F(Striker, ByChanceNothingIsLearned) {
  practice_.shuffled = true;
  const auto grown = grow(start_, striker(), {.attempts = 60, .selection = 100, .most = 3}, practice_);
  ASSERT_TRUE(grown);
  EXPECT_TRUE(grown->changes.empty());
  EXPECT_EQ(grown->strategy, start_);
}

TEST_F(Striker, TunesAMarkedNumber) {
  io::Json kicks = start_;
  kicks["tree"][2]["do"] = "kick";
  kicks["tree"][2]["with"] = {{"range", "5 m"}, {"tolerance", "$tolerance"}};
  const auto tuned =
      tune(kicks, striker(), {.generations = 6, .attempts = 40, .selection = 200, .test = 300}, 1, practice_);
  ASSERT_TRUE(tuned) << tuned.error();
  ASSERT_FALSE(tuned->changes.empty());
  EXPECT_EQ(text_of(tuned->changes[0]).substr(0, 23), "tolerance: 160 deg → ");
  EXPECT_TRUE(is_sure(tuned->gain));
  EXPECT_FALSE(tuned->curve.empty());
  // the mark stays
  EXPECT_EQ(tuned->strategy["parameters"]["tolerance"]["learn"], start_["parameters"]["tolerance"]["learn"]);
}

TEST_F(Striker, ALayerWithoutNumbersLeavesTheStrategyAsItIs) {
  const Layer none = *parse_layer(R"({"skills": ["pass"], "exercises": {"empty_goal": 1}})", "layer", "none");
  const auto tuned = tune(start_, none, {}, 1, practice_);
  ASSERT_TRUE(tuned);
  EXPECT_EQ(tuned->strategy, start_);
}

/// A whole run, small enough for a test.
LearnChoice small_run(const std::filesystem::path& folder) {
  std::ofstream(folder / "clumsy.json") << kClumsy;
  std::ofstream(folder / "striker.json") << R"({"skills": ["kick", "stand"], "conditions": ["ball_goal_distance"],
             "actions": [{"do": "kick", "with": {"range": "5 m"}}], "exercises": {"empty_goal": 1}})";
  return {.strategy = (folder / "clumsy.json").string(),
          .layers = {(folder / "striker.json").string()},
          .minutes = 0.001,
          .seed = 4,
          .world = {.rules = "spl2012,half_duration=30", .threads = 2},
          .unseen = {},
          .most_pairs = 50,
          .folder = {},
          .name = "better"};
}

const Tell kSilent = [](const std::string&, double) {};

TEST(Learning, ThreadsAndKillsChangeNothing) {
  const tests::TemporaryFolder folder;
  LearnChoice choice = small_run(folder.path());
  const auto once = learn(choice, kSilent);
  ASSERT_TRUE(once) << once.error();
  EXPECT_EQ(once->learned["name"], "better");
  choice.world.threads = 1;
  choice.folder = folder.path() / "run";
  const auto kept = learn(choice, kSilent);
  ASSERT_TRUE(kept) << kept.error();
  EXPECT_EQ(kept->learned.dump(2), once->learned.dump(2));
  EXPECT_EQ(kept->changes, once->changes);
  // a kill leaves a part of the ledger, with a torn line at its end
  const auto ledger = choice.folder / "ledger-0.txt";
  const auto size = std::filesystem::file_size(ledger);
  for (const double share : {0.1, 0.5, 0.95}) {
    std::filesystem::resize_file(ledger, static_cast<std::uintmax_t>(share * static_cast<double>(size)));
    const auto again = learn(choice, kSilent);
    ASSERT_TRUE(again) << again.error();
    EXPECT_EQ(again->learned.dump(2), once->learned.dump(2));
    EXPECT_EQ(std::filesystem::file_size(ledger), size);
  }
}

TEST(Learning, ProcessesThatShareARunLearnWhatOneLearns) {
  const tests::TemporaryFolder folder;
  LearnChoice choice = small_run(folder.path());
  choice.unseen = {"idle"}, choice.world.rules = "spl2012,half_duration=10";
  const auto alone = learn(choice, kSilent);
  ASSERT_TRUE(alone) << alone.error();
  choice.folder = folder.path() / "run";
  std::optional<robot::Result<Course>> courses[3];
  std::vector<std::thread> processes;
  for (const int number : {0, 1, 2})
    processes.emplace_back([&, number] {
      LearnChoice own = choice;
      own.share = {number, 3};
      own.world.threads = 1;
      courses[number] = learn(own, kSilent);
    });
  for (std::thread& process : processes) process.join();
  for (const auto& course : courses) {
    ASSERT_TRUE(*course) << course->error();
    EXPECT_EQ((*course)->learned.dump(2), alone->learned.dump(2));
  }
  // the first one has the gate's answer, the same as alone
  ASSERT_EQ((*courses[0])->gate.size(), alone->gate.size());
  EXPECT_TRUE((*courses[1])->gate.empty());
  for (std::size_t i = 0; i < alone->gate.size(); ++i)
    EXPECT_EQ((*courses[0])->gate[i].outcome.tally.gain, alone->gate[i].outcome.tally.gain);
  // a fourth process finds all results and adds nothing
  choice.share = {3, 4};
  ASSERT_TRUE(learn(choice, kSilent));
  EXPECT_EQ(std::filesystem::file_size(choice.folder / "ledger-3.txt"), 0u);
}

TEST(Learning, AFolderOfAnotherRunIsRefused) {
  const tests::TemporaryFolder folder;
  LearnChoice choice = small_run(folder.path());
  choice.folder = folder.path() / "run";
  ASSERT_TRUE(learn(choice, kSilent));
  // a layer that was edited meanwhile is another one
  const std::string layer = *robot::read_file(choice.layers[0], 1 << 20);
  std::ofstream(choice.layers[0]) << layer << " ";
  EXPECT_FALSE(learn(choice, kSilent));
  std::ofstream(choice.layers[0]) << layer;
  EXPECT_TRUE(learn(choice, kSilent));
  choice.seed = 5;
  const auto other = learn(choice, kSilent);
  ASSERT_FALSE(other);
  EXPECT_NE(other.error().find("expected the same strategy, layers, drills, budget, seed and opponents as before"),
            std::string::npos);
}

TEST(Learning, WrongNamesAreSentences) {
  EXPECT_NE(learn({.strategy = "baselin", .layers = {"kick"}}, kSilent).error().find("baseline"), std::string::npos);
  EXPECT_NE(learn({.strategy = "baseline", .layers = {"kik"}}, kSilent).error().find("kick"), std::string::npos);
}

TEST(Learning, AnOpponentOfPracticeIsNotUnseen) {
  const robot::Result<Course> course =
      learn({.strategy = "baseline", .layers = {"kick"}, .world = {.opponents = {"kick_now"}}, .unseen = {"kick_now"}},
            kSilent);
  ASSERT_FALSE(course);
  EXPECT_NE(course.error().find("must be others than those of practice, got 'kick_now'"), std::string::npos);
}

TEST(Learning, TheBudgetIsGamesAndNotTime) {
  EXPECT_EQ(Budget::of_minutes(10).seconds, 10 * Budget::of_minutes(1).seconds);
  EXPECT_GT(Budget::of_minutes(1).seconds, 0);
}

}  // namespace
}  // namespace sim::learn
