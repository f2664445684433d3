#include "robot/app/services/announced_parameter.h"

#include <gtest/gtest.h>

#include <cmath>
#include <functional>
#include <limits>

namespace robot::app {
namespace {

using foresight::LiveParameter;

constexpr double kInfinity = std::numeric_limits<double>::infinity();
constexpr double kNaN = std::numeric_limits<double>::quiet_NaN();

LiveParameter announced(LiveParameter::Type type) {
  LiveParameter parameter;
  parameter.set_name("speed");
  parameter.set_type(type);
  if (type == LiveParameter::TYPE_CHOICE) {
    parameter.add_choice("slow");
    parameter.add_choice("fast");
    parameter.set_text("fast");
    parameter.set_initial_text("slow");
  } else if (type == LiveParameter::TYPE_TEXT) {
    parameter.set_text("a");
    parameter.set_initial_text("b");
  } else {
    parameter.set_number(1);
  }
  return parameter;
}

std::string refusal(LiveParameter::Type type, const std::function<void(LiveParameter&)>& change) {
  LiveParameter parameter = announced(type);
  change(parameter);
  const auto offered = offered_parameter(parameter, "walk");
  return offered ? "" : offered.error();
}

TEST(AnnouncedParameter, EveryTypeComesBackAsItWasAnnounced) {
  for (const auto type : {LiveParameter::TYPE_NUMBER, LiveParameter::TYPE_WHOLE, LiveParameter::TYPE_YES_NO,
                          LiveParameter::TYPE_TEXT, LiveParameter::TYPE_CHOICE, LiveParameter::TYPE_BUTTON}) {
    const LiveParameter parameter = announced(type);
    const auto offered = offered_parameter(parameter, "walk");
    ASSERT_TRUE(offered) << offered.error();
    EXPECT_EQ(offered->name, "walk.speed");
    LiveParameter back = parameter;
    back.clear_number();
    back.clear_text();
    put_value(back, offered->present);
    EXPECT_EQ(back.SerializeAsString(), parameter.SerializeAsString());
  }
}

TEST(AnnouncedParameter, AWrongOneIsRefusedWithASentence) {
  const auto number = [](const auto& change) { return refusal(LiveParameter::TYPE_NUMBER, change); };
  EXPECT_EQ(number([](auto& p) { p.set_name(""); }),
            "parameter '': expected a name of 1 to 48 letters, digits, '_', '-' and '.'");
  EXPECT_NE(number([](auto& p) { p.set_name("step height"); }), "");
  EXPECT_NE(number([](auto& p) { p.set_name("ä"); }), "");
  EXPECT_NE(number([](auto& p) { p.set_name(std::string(49, 'a')); }), "");
  EXPECT_EQ(number([](auto& p) { p.set_name(std::string(48, 'a')); }), "");
  EXPECT_EQ(number([](auto& p) { p.set_unit(std::string(17, 'm')); }),
            "parameter 'speed': expected a unit of at most 16 bytes");
  EXPECT_EQ(number([](auto& p) { p.set_description(std::string(201, 'm')); }),
            "parameter 'speed': expected a description of at most 200 bytes");
  EXPECT_EQ(number([](auto& p) { p.clear_type(); }),
            "parameter 'speed': expected a number, whole number, yes or no, text, choice or button, got another type");
  EXPECT_NE(number([](auto& p) { p.set_type(static_cast<LiveParameter::Type>(99)); }), "");
  EXPECT_EQ(number([](auto& p) { p.set_number(kNaN); }), "parameter 'speed': expected a finite number, got nan");
  EXPECT_NE(number([](auto& p) { p.set_initial_number(kInfinity); }), "");
  EXPECT_EQ(number([](auto& p) { p.set_min(2), p.set_max(1); }),
            "parameter 'speed': expected a range whose minimum is below its maximum");
  EXPECT_NE(number([](auto& p) { p.set_min(kNaN); }), "");
  EXPECT_EQ(number([](auto& p) { p.set_min(2), p.set_max(kInfinity), p.set_initial_number(3); }),
            "parameter 'speed': expected at least 2, got 1");
  EXPECT_EQ(refusal(LiveParameter::TYPE_WHOLE, [](auto& p) { p.set_number(0.5); }),
            "parameter 'speed': expected values of its type, got others");
  EXPECT_NE(refusal(LiveParameter::TYPE_WHOLE, [](auto& p) { p.set_number(1e16); }), "");
  EXPECT_EQ(refusal(LiveParameter::TYPE_BUTTON, [](auto& p) { p.set_number(-1); }),
            "parameter 'speed': expected at least 0, got -1");
  EXPECT_NE(refusal(LiveParameter::TYPE_BUTTON, [](auto& p) { p.set_number(0.5); }), "");
  EXPECT_NE(refusal(LiveParameter::TYPE_YES_NO, [](auto& p) { p.set_number(2); }), "");
  EXPECT_EQ(refusal(LiveParameter::TYPE_TEXT, [](auto& p) { p.set_text(std::string(201, 'a')); }),
            "parameter 'speed': expected a text of at most 200 bytes");
  EXPECT_EQ(refusal(LiveParameter::TYPE_CHOICE, [](auto& p) { p.set_text("faster"); }),
            "parameter 'speed': expected one of slow, fast, got 'faster'");
  EXPECT_EQ(refusal(LiveParameter::TYPE_CHOICE, [](auto& p) { p.clear_choice(); }),
            "parameter 'speed': expected 1 to 32 choices, got 0");
  EXPECT_NE(refusal(LiveParameter::TYPE_CHOICE, [](auto& p) { p.add_choice(""); }), "");
}

TEST(AnnouncedParameter, ProcessesHavePlainNames) {
  EXPECT_TRUE(is_process_name("walk_2-b"));
  for (const std::string name : {"", "a.b", "a/b", "a b", "ü"}) EXPECT_FALSE(is_process_name(name)) << name;
  EXPECT_TRUE(is_process_name(std::string(32, 'a')));
  EXPECT_FALSE(is_process_name(std::string(33, 'a')));
}

}  // namespace
}  // namespace robot::app
