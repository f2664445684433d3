#include "robot/lab/whole/runs.h"

#include <gtest/gtest.h>

#include "robot/core/clock.h"

namespace robot::lab {
namespace {

using Words = std::vector<std::string>;

TEST(Runs, EndWhereAMessageSaysSomethingElse) {
  Runs runs;
  for (std::uint64_t i = 0; i < 10; ++i) runs.add(i, {i < 4 ? "stand" : "walk", i < 7 ? "keeper" : "striker"});
  ASSERT_EQ(runs.runs().size(), 3u);
  EXPECT_EQ(runs.words(), (Words{"stand", "keeper", "walk", "striker"}));
  EXPECT_EQ(runs.runs()[0].from_ns, 0u);
  EXPECT_EQ(runs.runs()[0].to_ns, 4u) << "until the next one";
  EXPECT_EQ(runs.runs()[1].words, (std::vector<std::uint32_t>{2, 1}));
  EXPECT_EQ(runs.runs()[2].from_ns, 7u);
  EXPECT_EQ(runs.runs()[2].to_ns, 9u) << "until the last message";
}

TEST(Runs, EndWhereNoMessageComesForLong) {
  Runs runs;
  runs.add(1, {"walk"});
  runs.add(1 + Runs::kGapNs, {"walk"});
  runs.add(2 + 2 * Runs::kGapNs, {"walk"});
  ASSERT_EQ(runs.runs().size(), 2u);
  EXPECT_EQ(runs.runs()[0].to_ns, 1 + Runs::kGapNs);
  EXPECT_EQ(runs.runs()[1].from_ns, 2 + 2 * Runs::kGapNs);
}

TEST(Runs, TimesThatGoBackAreLeftOut) {
  Runs runs;
  runs.add(10, {"walk"});
  runs.add(20, {"walk"});
  runs.add(15, {"kick"});
  ASSERT_EQ(runs.runs().size(), 1u);
  EXPECT_EQ(runs.runs()[0].to_ns, 20u);
}

TEST(Runs, KeepABoundedNumber) {
  Runs runs;
  for (std::uint64_t i = 0; i < Runs::kMost; ++i) runs.add(i, {i % 2 == 0 ? "stand" : "walk"});
  EXPECT_FALSE(runs.full());
  for (std::uint64_t i = 0; i < 10; ++i) runs.add(Runs::kMost + i, {i % 2 == 0 ? "stand" : "walk"});
  EXPECT_TRUE(runs.full());
  EXPECT_EQ(runs.runs().size(), Runs::kMost);
}

TEST(Runs, KeepABoundedNumberOfWords) {
  Runs runs;
  for (std::uint64_t i = 0; i < Runs::kMostWords + 10; ++i) runs.add(i, {std::to_string(i)});
  EXPECT_EQ(runs.words().size(), Runs::kMostWords + 1);
  EXPECT_EQ(runs.words().back(), "…");
}

}  // namespace
}  // namespace robot::lab
