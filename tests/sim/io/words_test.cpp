#include "sim/io/words.h"

#include <gtest/gtest.h>

#include <random>

namespace sim::io {
namespace {

using Known = std::vector<std::string_view>;

TEST(EditsBetween, CountsLettersToInsertRemoveReplaceOrExchangeWithTheirNeighbour) {
  EXPECT_EQ(edits_between("", ""), 0u);
  EXPECT_EQ(edits_between("ball", "ball"), 0u);
  EXPECT_EQ(edits_between("bal", "ball"), 1u);
  EXPECT_EQ(edits_between("balll", "ball"), 1u);
  EXPECT_EQ(edits_between("bell", "ball"), 1u);
  EXPECT_EQ(edits_between("blal", "ball"), 1u);
  EXPECT_EQ(edits_between("", "ball"), 4u);
  EXPECT_EQ(edits_between("kick", "pass"), 4u);
}

TEST(EditsBetween, IsSymmetricAndNeverMoreThanTheLongerWord) {
  std::mt19937 random(1);
  const auto word = [&] {
    std::string letters(random() % 9, ' ');
    for (char& letter : letters) letter = static_cast<char>('a' + random() % 3);
    return letters;
  };
  for (int i = 0; i < 5000; ++i) {
    const std::string a = word(), b = word();
    const std::size_t edits = edits_between(a, b);
    EXPECT_EQ(edits, edits_between(b, a)) << a << " " << b;
    EXPECT_LE(edits, std::max(a.size(), b.size())) << a << " " << b;
    EXPECT_EQ(edits == 0, a == b) << a << " " << b;
  }
}

TEST(DidYouMean, NamesTheMostSimilarWords) {
  const Known known = {"ball_x", "ball_y", "ball_age", "role", "ball_z", "ball_w"};
  EXPECT_EQ(did_you_mean("bal_age", known), "; did you mean 'ball_age'?");
  EXPECT_EQ(did_you_mean("rloe", known), "; did you mean 'role'?");
  EXPECT_EQ(did_you_mean("ball_v", {"ball_x", "ball_y", "role"}), "; did you mean 'ball_x' or 'ball_y'?");
  EXPECT_EQ(did_you_mean("ball_v", known), "; did you mean 'ball_x', 'ball_y' or 'ball_z'?");  // at most three
}

TEST(DidYouMean, IsEmptyIfNoneIsSimilar) {
  EXPECT_EQ(did_you_mean("keeper", {"ball_x", "ball_y"}), "");
  EXPECT_EQ(did_you_mean("z", {"x", "y"}), "");  // no letter would remain
  EXPECT_EQ(did_you_mean("", {"x"}), "");
  EXPECT_EQ(did_you_mean(std::string(1000, 'x'), {"x"}), "");
  EXPECT_EQ(did_you_mean("x", {}), "");
}

TEST(Hint, ListsFewWordsAndNotManyIfNoneIsSimilar) {
  EXPECT_EQ(hint("mach", {"match", "perfect"}), "; did you mean 'match'?");
  EXPECT_EQ(hint("reality", {"match", "perfect"}), "; there are: match, perfect");
  EXPECT_EQ(hint("reality", Known(100, "match")), "");
  EXPECT_EQ(hint("reality", {}), "; there are none");
}

}  // namespace
}  // namespace sim::io
