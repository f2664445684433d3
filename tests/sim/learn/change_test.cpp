#include "sim/learn/change.h"

#include <gtest/gtest.h>

namespace sim::learn {
namespace {

TEST(Change, IsALine) {
  EXPECT_EQ(text_of({"near_ball", "0.5 m", "0.62 m"}), "near_ball: 0.5 m → 0.62 m");
  EXPECT_EQ(text_of({"shoot / free", "", ""}), "shoot / free: removed, worth nothing");
}

TEST(Change, OfOneNumberIsOne) {
  const std::vector<Change> merge = merged({{"near", "1 m", "2 m"}, {"far", "5 m", "6 m"}, {"near", "2 m", "3 m"}});
  EXPECT_EQ(merge, (std::vector<Change>{{"near", "1 m", "3 m"}, {"far", "5 m", "6 m"}}));
}

TEST(Change, WithinARemovedRuleIsGone) {
  const std::vector<Change> merge = merged({{"shoot / free: range", "1 m", "2 m"},
                                            {"shoot / free", "kick", "dribble"},
                                            {"shoot / freely: range", "1 m", "2 m"},
                                            {"shoot / free", "", ""}});
  EXPECT_EQ(merge, (std::vector<Change>{{"shoot / freely: range", "1 m", "2 m"}, {"shoot / free", "", ""}}));
}

}  // namespace
}  // namespace sim::learn
