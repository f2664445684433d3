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

TEST(Joined, IsSplitIntoItsPartsAgain) {
  EXPECT_EQ(joined({}, ", "), "");
  for (const std::vector<std::string>& parts :
       {std::vector<std::string>{"ball"}, {"ball", "pose"}, {"", "a", ""}, {"truth/world", "b", "c"}}) {
    const std::string text = joined(parts, ", ");
    const Parts again = split(text, ", ");
    EXPECT_EQ(std::vector<std::string>(again.begin(), again.end()), parts) << text;
  }
}

}  // namespace
}  // namespace robot
