// Getting up in the physics, a small part of `scripts/bench walk`.
#include "tests/walk/rise.h"

#include <gtest/gtest.h>

#include "tests/walk/lola_body.h"

namespace robot::nao {
namespace {

class Rising : public ::testing::TestWithParam<Lying> {};

TEST_P(Rising, ADroppedRobotLiesOnThatSide) {
  for (const std::uint64_t seed : {1, 2, 3}) {
    LolaBody body(walk::draw_robot(seed, walk::Servos::stiff), seed, false, true);
    body.drop(draw_drop(GetParam(), seed));
    EXPECT_EQ(lying(body.sensors.angles), GetParam());
    for (int i = 0; i < 100; ++i) body.obey({});
    EXPECT_FALSE(body.upright());
    EXPECT_LT(body.truth().height, 0.15);
  }
}

TEST_P(Rising, RobotsOfBothClassesGetUp) {
  int stood = 0;
  for (const walk::Servos servos : {walk::Servos::stiff, walk::Servos::soft})
    for (const std::uint64_t seed : {1, 2}) {
      const Rise result = rise(servos, seed, GetParam());
      stood += result.stood;
      EXPECT_TRUE(!result.stood || result.seconds > 5) << result.seconds;
    }
  EXPECT_GE(stood, 3) << "of 4";
}

TEST(Rise, IsTheSameEachTime) {
  const Rise first = rise(walk::Servos::stiff, 1, Lying::on_back), again = rise(walk::Servos::stiff, 1, Lying::on_back);
  EXPECT_EQ(first.stood, again.stood);
  EXPECT_EQ(first.failed, again.failed);
  EXPECT_EQ(first.seconds, again.seconds);
}

INSTANTIATE_TEST_SUITE_P(FromEachSide, Rising,
                         ::testing::Values(Lying::on_back, Lying::on_front, Lying::on_left, Lying::on_right),
                         [](const auto& tested) {
                           switch (tested.param) {
                             case Lying::on_back: return "Back";
                             case Lying::on_front: return "Front";
                             case Lying::on_left: return "Left";
                             case Lying::on_right: return "Right";
                           }
                           return "None";
                         });

}  // namespace
}  // namespace robot::nao
