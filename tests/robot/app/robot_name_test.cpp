#include "robot/app/robot_name.h"

#include <gtest/gtest.h>

namespace robot::app {
namespace {

TEST(RobotName, IsTheSameAfterFormattingAndParsing) {
  for (const char* text : {"14/2", "0/1", "255/99"}) EXPECT_EQ(parse_robot_name(text)->text(), text);
}

TEST(RobotName, RefusesOtherTexts) {
  for (const char* text : {"", "14", "14/", "/2", "14/0", "14/100", "256/1", "-1/2", "14/2/3", "14/2 ", "a/b", "14 /2"})
    EXPECT_EQ(parse_robot_name(text).error(),
              "robot: expected <team 0..255>/<player 1..99> such as 14/2, got '" + std::string(text) + "'");
}

}  // namespace
}  // namespace robot::app
