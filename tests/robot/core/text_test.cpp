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

TEST(TakeLine, EndsAtEitherLineEndOrTheText) {
  std::string_view text = "a\r\n\nb\rc\nd";
  for (const char* line : {"a", "", "b\rc", "d"}) EXPECT_EQ(take_line(text), line);
  EXPECT_EQ(text, "");
  EXPECT_EQ(take_line(text), "");
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

TEST(Printable, IsShortAndAscii) {
  EXPECT_EQ(printable("P0 ~ok", 20), "P0 ~ok");
  EXPECT_EQ(printable("a\n\x7f\xc3\xa4", 20), "a????");
  EXPECT_EQ(printable("abc", 2), "ab");
  EXPECT_EQ(printable("", 2), "");
}

TEST(Formatted, HasAnyLength) {
  EXPECT_EQ(formatted("%d of %.1f s in %s", 3, 0.25, "READY"), "3 of 0.2 s in READY");
  for (const std::size_t size : {0u, 1u, 299u, 300u, 100'000u}) {
    const std::string text(size, 'x');
    EXPECT_EQ(formatted("%s|%s", text.c_str(), text.c_str()), text + "|" + text);
  }
}

}  // namespace
}  // namespace robot
