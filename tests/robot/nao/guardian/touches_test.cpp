#include "robot/nao/guardian/touches.h"

#include <gtest/gtest.h>

#include "tests/support/fake_body.h"

namespace robot::nao {
namespace {

struct NaoTouches : ::testing::Test {
  tests::FakeBody body;
  Touches touches;
  std::uint64_t now_ns = 0;

  /// Returns whether the button clicked in one of `cycles` cycles.
  bool see(int cycles) {
    bool clicked = false;
    for (int i = 0; i < cycles; ++i) {
      touches.see(body.sensors, now_ns += tests::kCycle_ns);
      clicked = clicked || touches.clicked();
    }
    return clicked;
  }
  bool press(int cycles) {
    body.press_chest(true);
    EXPECT_FALSE(see(cycles)) << "it counts when it is released";
    body.press_chest(false);
    return see(2);
  }
};

TEST_F(NaoTouches, CountAPressOfTheChestButtonOnce) {
  EXPECT_TRUE(press(Touches::kPressFrames));
  EXPECT_FALSE(see(100));
  EXPECT_TRUE(press(30));
}

TEST_F(NaoTouches, TakeASingleFrameForAWrongReading) {
  EXPECT_FALSE(press(1));
  body.hold_head(true);
  see(Touches::kHeldFrames - 1);
  EXPECT_FALSE(touches.head_held());
  body.hold_head(false);
  see(1);
  body.hold_head(true);
  see(1);
  EXPECT_FALSE(touches.head_held());
}

TEST_F(NaoTouches, LeaveALongPressToTheRobot) { EXPECT_FALSE(press(130)); }

TEST_F(NaoTouches, NoticeThatAllThreeHeadSensorsAreHeld) {
  body.hold_head(true);
  see(Touches::kHeldFrames);
  EXPECT_TRUE(touches.head_held());
  see(1000);
  EXPECT_TRUE(touches.head_held());
  body.sensors.touch[2] = 0;
  see(1);
  EXPECT_FALSE(touches.head_held());
}

}  // namespace
}  // namespace robot::nao
