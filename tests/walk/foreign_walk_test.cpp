#include "tests/walk/foreign_walk.h"

#include <gtest/gtest.h>

#include "tests/walk/our_gait.h"

namespace robot::nao::walk {
namespace {

TEST(ForeignWalk, OurWalkAsALibraryWalksLikeOurs) {
  const auto library = ForeignWalk::load(WALK_LIBRARY);
  ASSERT_TRUE(library) << library.error();
  EXPECT_EQ(library->stand(), stand());
  EXPECT_EQ(library->hip_height(), Parameters{}.hip_height);
  const auto course = [](Gait& gait) {
    Physics physics({});
    return run(physics, gait, draw_robot(7, Servos::stiff), 7, stand(), Parameters{}.hip_height,
               {.duration = 5, .command = [](double) { return Command{.forward = 0.15, .turn = 0.2}; }});
  };
  OurGait ours;
  const auto theirs = library->begin();
  ASSERT_TRUE(theirs);
  const Outcome expected = course(ours), found = course(*theirs);
  EXPECT_EQ(found.forward, expected.forward);
  EXPECT_EQ(found.turned, expected.turned);
  EXPECT_EQ(found.path, expected.path);
  EXPECT_EQ(found.last_step, expected.last_step);
}

TEST(ForeignWalk, ALibraryThatIsNoneIsRefusedWithASentence) {
  const auto missing = ForeignWalk::load("/nowhere/libwalk.so");
  ASSERT_FALSE(missing);
  EXPECT_NE(missing.error().find("/nowhere/libwalk.so"), std::string::npos) << missing.error();
  const auto other = ForeignWalk::load(MUJOCO_LIBRARY);
  ASSERT_FALSE(other);
  EXPECT_NE(
      other.error().find("lacks foresight_walk_stand, foresight_walk_begin, foresight_walk_tick, foresight_walk_end"),
      std::string::npos)
      << other.error();
}

}  // namespace
}  // namespace robot::nao::walk
