#include "robot/app/rules_field.h"

#include <gtest/gtest.h>

namespace robot::app {
namespace {

TEST(FieldOf, UnknownRulesIsTheNewest) {
  EXPECT_EQ(field_of("spl2012").length(), 6);
  EXPECT_EQ(field_of("no such rules").length(), field_of("").length());
  EXPECT_EQ(field_of("").length(), 9);
}

}  // namespace
}  // namespace robot::app
