#include "robot/core/text.h"

#include <gtest/gtest.h>

namespace robot {
namespace {

using Parts = std::vector<std::string_view>;

TEST(Trimmed, KeepsBlanksInside) {
  EXPECT_EQ(trimmed(" \t a b\r\n"), "a b");
  EXPECT_EQ(trimmed("a"), "a");
  for (const char* blank : {"", " ", "\t\r\n "}) EXPECT_EQ(trimmed(blank), "");
}

TEST(Split, HasOnePartMoreThanSeparators) {
  EXPECT_EQ(split("a,b", ","), (Parts{"a", "b"}));
  EXPECT_EQ(split(" a ,", ","), (Parts{" a ", ""}));
  EXPECT_EQ(split(",", ","), (Parts{"", ""}));
  EXPECT_EQ(split("", ","), (Parts{""}));
  EXPECT_EQ(split("a or b or c", " or "), (Parts{"a", "b", "c"}));
  EXPECT_EQ(split("a or", " or "), (Parts{"a or"}));
}

}  // namespace
}  // namespace robot
