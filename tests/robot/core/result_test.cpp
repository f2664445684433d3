#include "robot/core/result.h"

#include <gtest/gtest.h>

#include <memory>
#include <string>

namespace robot {
namespace {

TEST(Result, IsAValueOrASentence) {
  const Result<int> good = 7;
  ASSERT_TRUE(good);
  EXPECT_EQ(*good, 7);

  const Result<int> bad = Error{"team file: expected a number, got 'x'"};
  ASSERT_FALSE(bad);
  EXPECT_EQ(bad.error(), "team file: expected a number, got 'x'");
}

TEST(Result, HoldsAValueThatCanOnlyBeMoved) {
  Result<std::unique_ptr<int>> made = std::make_unique<int>(3);
  const std::unique_ptr<int> taken = std::move(made).value();
  EXPECT_EQ(*taken, 3);
}

TEST(Result, OfVoidIsSuccessOrASentence) {
  EXPECT_TRUE(Result<void>());
  const Result<void> failed = Error{"disk full"};
  ASSERT_FALSE(failed);
  EXPECT_EQ(failed.error(), "disk full");
}

Result<int> read_number(bool good) {
  if (!good) return Error{"expected a number, got 'x'"};
  return 7;
}

Result<void> check_number(bool good) {
  const Result<int> number = read_number(good);
  if (!number) return number.failure();
  return {};
}

Result<std::string> read_team(bool good) {
  if (const Result<void> checked = check_number(good); !checked) return checked.failure("team file");
  return std::string("Bremen");
}

TEST(Result, HandsItsErrorOnAsItIs) {
  EXPECT_TRUE(check_number(true));
  ASSERT_FALSE(check_number(false));
  EXPECT_EQ(check_number(false).error(), read_number(false).error());
}

TEST(Result, HandsItsErrorOnWithThePlaceBeforeIt) {
  ASSERT_TRUE(read_team(true));
  EXPECT_EQ(*read_team(true), "Bremen");
  ASSERT_FALSE(read_team(false));
  EXPECT_EQ(read_team(false).error(), "team file: expected a number, got 'x'");
}

TEST(Result, PutsEachPlaceBeforeTheOneInside) {
  const Result<int> inside = read_number(false).failure("line 3");
  EXPECT_EQ(inside.failure("team file").sentence, "team file: line 3: expected a number, got 'x'");
}

}  // namespace
}  // namespace robot
