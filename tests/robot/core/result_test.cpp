#include "robot/core/result.h"

#include <gtest/gtest.h>

#include <memory>

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

TEST(Result, CarriesWhatCanOnlyBeMoved) {
  Result<std::unique_ptr<int>> made = std::make_unique<int>(3);
  const std::unique_ptr<int> taken = std::move(made).value();
  EXPECT_EQ(*taken, 3);
}

TEST(Result, OfNothingIsDoneOrASentence) {
  EXPECT_TRUE(Result<void>());
  const Result<void> failed = Error{"disk full"};
  ASSERT_FALSE(failed);
  EXPECT_EQ(failed.error(), "disk full");
}

}  // namespace
}  // namespace robot
