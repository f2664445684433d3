// An independent reader of MessagePack finds the actuator values in the frame.
#include "robot/nao/lola/actuators.h"
#include "robot/core/json_library.h"

#include <gtest/gtest.h>

namespace robot::nao {
namespace {

using nlohmann::json;

TEST(LolaActuators, AreReadAsTheyWereSent) {
  Actuators said;
  for (std::size_t i = 0; i < kJoints; ++i) {
    said.position[i] = 0.125f * static_cast<float>(i) - 1;
    said.stiffness[i] = 0.03125f * static_cast<float>(i);
  }
  said.lights.chest = {1, 0.5f, 0.25f};
  said.lights.l_foot = {0, 0, 1};
  said.lights.r_foot = {0, 1, 0};
  said.lights.l_eye = {1, 0, 0.5f};
  said.lights.r_eye = {0, 0.5f, 1};
  said.lights.l_ear[3] = 1;
  said.lights.r_ear[9] = 0.5f;
  said.lights.skull[11] = 0.75f;

  ActuatorFrame frame;
  static_cast<void>(frame.compose({}));  // values of the previous frame are overwritten
  const std::string_view bytes = frame.compose(said);
  EXPECT_EQ(bytes.size(), 786u);
  const json heard = json::from_msgpack(bytes);
  EXPECT_EQ(heard.size(), 11u);
  EXPECT_EQ(heard["Position"].get<PerJoint<float>>(), said.position);
  EXPECT_EQ(heard["Stiffness"].get<PerJoint<float>>(), said.stiffness);
  EXPECT_EQ(heard["Chest"], json({1, 0.5, 0.25}));
  EXPECT_EQ(heard["LFoot"], json({0, 0, 1}));
  EXPECT_EQ(heard["RFoot"], json({0, 1, 0}));
  // eight red values, eight green, eight blue
  EXPECT_EQ(heard["LEye"], json({1, 1, 1, 1, 1, 1, 1, 1, 0, 0, 0, 0, 0, 0, 0, 0, .5, .5, .5, .5, .5, .5, .5, .5}));
  EXPECT_EQ(heard["REye"], json({0, 0, 0, 0, 0, 0, 0, 0, .5, .5, .5, .5, .5, .5, .5, .5, 1, 1, 1, 1, 1, 1, 1, 1}));
  EXPECT_EQ(heard["LEar"], json({0, 0, 0, 1, 0, 0, 0, 0, 0, 0}));
  EXPECT_EQ(heard["REar"], json({0, 0, 0, 0, 0, 0, 0, 0, 0, 0.5}));
  EXPECT_EQ(heard["Skull"], json({0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0.75}));
  EXPECT_EQ(heard["Sonar"], json({true, true}));
  said.sonar = false;
  EXPECT_EQ(json::from_msgpack(frame.compose(said))["Sonar"], json({false, false}));
}

}  // namespace
}  // namespace robot::nao
