#include "sim/contest/contest.h"

#include <gtest/gtest.h>
#include <signal.h>
#include <sys/wait.h>
#include <unistd.h>

#include "tests/support/eventually.h"
#include "tests/support/temporary_folder.h"

namespace sim::contest {
namespace {

using Use = RunFolder::Use;

constexpr std::int64_t kPairs = 4 * RunFolder::kPairsPerBlock;

const Comparison& comparison() {
  static const Comparison made =
      Comparison::prepare(
          {.a = "baseline", .b = "kick_now", .players = 2, .seconds = 20, .metric = Metric::ball_advance})
          .value();
  return made;
}

RunFolder opened(const std::filesystem::path& folder, Use use) {
  auto run = RunFolder::open(folder, comparison().specification(), use);
  EXPECT_TRUE(run) << run.error();
  return *std::move(run);
}

compare::PairStatistics statistics_of(const RunFolder* run, int jobs) {
  const auto outcome = play_contest(comparison(), {.question = {}, .pairs = kPairs, .jobs = jobs}, run, {});
  EXPECT_TRUE(outcome) << outcome.error();
  return outcome->tally;
}

void expect_equal_blocks(const RunFolder& one, const RunFolder& other) {
  ASSERT_EQ(one.blocks(), other.blocks());
  for (std::int64_t block = 0; block < one.blocks(); ++block) EXPECT_EQ(*one.read(block), *other.read(block));
}

TEST(Contest, HasTheSameBlocksForAnyNumberOfJobs) {
  const tests::TemporaryFolder folder;
  const RunFolder alone = opened(folder / "alone", Use::begin), together = opened(folder / "together", Use::begin);
  const compare::PairStatistics expected = statistics_of(&alone, 1);
  EXPECT_EQ(expected.pairs, kPairs);
  EXPECT_EQ(statistics_of(&together, 3), expected);
  EXPECT_EQ(statistics_of(nullptr, 2), expected);
  expect_equal_blocks(alone, together);

  // blocks on the disk are not played again, and their merge is the same run
  const auto merged = merge(comparison(), {.question = {}, .pairs = kPairs}, together);
  ASSERT_TRUE(merged) << merged.error();
  EXPECT_EQ(merged->tally, expected);
}

TEST(Contest, ContinuesAfterAKillToTheSameResult) {
  const tests::TemporaryFolder folder;
  const RunFolder whole = opened(folder / "whole", Use::begin);
  const compare::PairStatistics expected = statistics_of(&whole, 2);

  const pid_t child = fork();
  ASSERT_GE(child, 0);
  if (child == 0) {
    const auto run = RunFolder::open(folder / "killed", comparison().specification(), Use::begin);
    if (run) (void)play_contest(comparison(), {.question = {}, .pairs = 1000 * kPairs, .jobs = 2}, &*run, {});
    _exit(0);
  }
  const std::filesystem::path first_block = folder / "killed/block-00000000.json";
  const bool began = static_cast<bool>(tests::eventually([&] { return std::filesystem::exists(first_block); }));
  kill(child, SIGKILL);
  waitpid(child, nullptr, 0);
  ASSERT_TRUE(began);

  // the lock ends with the last worker, which ends soon after the killed process
  std::optional<RunFolder> killed;
  ASSERT_TRUE(tests::eventually([&] {
    auto run = RunFolder::open(folder / "killed", comparison().specification(), Use::go_on);
    if (run) killed.emplace(*std::move(run));
    return killed.has_value();
  }));
  EXPECT_EQ(statistics_of(&*killed, 2), expected);
  for (std::int64_t block = 0; block < whole.blocks(); ++block) EXPECT_EQ(*whole.read(block), *killed->read(block));
}

TEST(Contest, PartsThatOthersPlayAreTheSameRun) {
  const tests::TemporaryFolder folder;
  const RunFolder shared = opened(folder / "shared", Use::share);
  ASSERT_TRUE(play_blocks(comparison(), 2, 4, 1, shared));
  const auto early = merge(comparison(), {.question = {}, .pairs = kPairs}, shared);
  ASSERT_FALSE(early);
  EXPECT_EQ(early.error(), "run " + shared.path().string() + ": expected 4 blocks, 2 are missing: 0, 1");
  ASSERT_TRUE(play_blocks(comparison(), 0, 2, 2, shared));
  const auto merged = merge(comparison(), {.question = {}, .pairs = kPairs}, shared);
  ASSERT_TRUE(merged) << merged.error();
  EXPECT_EQ(merged->tally, statistics_of(nullptr, 2));
}

TEST(Contest, RefusesToMergeAFolderWithoutBlocks) {
  const tests::TemporaryFolder folder;
  const RunFolder empty = opened(folder / "empty", Use::begin);
  const auto merged = merge(comparison(), {}, empty);
  ASSERT_FALSE(merged);
  EXPECT_EQ(merged.error(), "run " + empty.path().string() + ": expected blocks of games, there are none");
}

TEST(Contest, FindsABehaviourIdenticalToItself) {
  const auto itself = Comparison::prepare({.a = "baseline", .b = "baseline", .players = 2, .seconds = 20});
  ASSERT_TRUE(itself) << itself.error();
  const auto outcome = play_contest(*itself, {.question = {}, .pairs = RunFolder::kPairsPerBlock}, nullptr, {});
  ASSERT_TRUE(outcome) << outcome.error();
  EXPECT_EQ(outcome->verdict, compare::Verdict::identical);
  EXPECT_EQ(outcome->tally.gain_squares, 0);
  EXPECT_EQ(outcome->different, RunFolder::kPairsPerBlock);
}

TEST(Contest, FindsDifferentGamesWithoutGoalsTooRareAndNotIdentical) {
  const auto differing =
      Comparison::prepare({.a = "align_first", .b = "kick_now", .situation = "far_free", .seconds = 3});
  ASSERT_TRUE(differing) << differing.error();
  const auto outcome = play_contest(*differing, {.question = {}, .pairs = 50}, nullptr, {});
  ASSERT_TRUE(outcome) << outcome.error();
  EXPECT_EQ(outcome->verdict, compare::Verdict::too_rare);
  EXPECT_EQ(outcome->tally.same, 0);
  EXPECT_EQ(outcome->different, 50);
}

TEST(Contest, RefusesPairsThatRepeat) {
  const auto played = [](bool fuzz, const char* b) {
    const auto comparison = Comparison::prepare(
        {.a = "align_first", .b = b, .models = "perfect", .situation = "near_free", .fuzz = fuzz, .seconds = 10});
    EXPECT_TRUE(comparison) << comparison.error();
    return play_contest(*comparison, {.question = {}, .pairs = 50}, nullptr, {});
  };
  const auto repeated = played(false, "kick_now");
  ASSERT_FALSE(repeated);
  EXPECT_EQ(repeated.error(),
            "the games repeat: expected 25 different pairs, got 1; with models 'perfect' a seed changes too little: "
            "choose models with noise, or vary the start with --from and --fuzz");
  const auto varied = played(true, "kick_now");
  ASSERT_TRUE(varied) << varied.error();
  EXPECT_EQ(varied->different, 50);
  // a behaviour against itself needs no luck
  const auto itself = played(false, "align_first");
  ASSERT_TRUE(itself) << itself.error();
  EXPECT_EQ(itself->verdict, compare::Verdict::identical);
  EXPECT_EQ(itself->different, 1);
}

TEST(Contest, TheHistogramHoldsEachPairOnce) {
  const auto outcome = play_contest(comparison(), {.question = {}, .pairs = 30, .jobs = 2}, nullptr, {});
  ASSERT_TRUE(outcome) << outcome.error();
  std::int64_t pairs = 0;
  for (const std::int64_t column : outcome->histogram) pairs += column;
  EXPECT_EQ(pairs, 30);
  EXPECT_EQ(outcome->tally.pairs, 30);
  EXPECT_EQ(outcome->marks.back().pairs, 30);
}

}  // namespace
}  // namespace sim::contest
