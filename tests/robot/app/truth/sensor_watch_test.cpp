#include "robot/app/truth/sensor_watch.h"

#include <gtest/gtest.h>

#include "tests/robot/app/truth/watching.h"
#include "tests/support/eventually.h"

namespace robot::app {
namespace {

TEST_F(Watching, ARecordingIsShownToItsEnd) {
  const std::uint64_t now_ns = clock.now_ns();
  watch({image_at(now_ns), image_at(now_ns + 30 * kMillisecond), image_at(now_ns + 60 * kMillisecond)});
  ASSERT_TRUE(tests::eventually([&] { return has_ended(); }));
  EXPECT_EQ(images(), 3u);
  EXPECT_EQ(world.read()->capture_ns(), now_ns + 60 * kMillisecond);
  EXPECT_FALSE(told().has_refused_tags()) << "it reads no tags";
}

TEST_F(Watching, ADamagedImageIsToldAndTheNextOneIsUsed) {
  const std::uint64_t now_ns = clock.now_ns();
  watch({Error{"image 1 is torn"}, image_at(now_ns + 30 * kMillisecond)});
  ASSERT_TRUE(tests::eventually([&] { return has_ended(); }));
  EXPECT_EQ(images(), 1u);
}

TEST_F(Watching, AnUnpluggedSensorIsAStateThatIsShown) {
  watch({image_at(clock.now_ns())}, true);
  ASSERT_TRUE(tests::eventually([&] { return told().problem() == "given:0 is unplugged"; }));
  EXPECT_EQ(told().state(), foresight::TruthSensor::STATE_WAITING);
  EXPECT_EQ(told().robots_size(), 0);
}

TEST_F(Watching, AnImageOfALiveSensorThatIsTooOldIsLeftOut) {
  watch({image_at(clock.now_ns() - kSecond), image_at(clock.now_ns() + 30 * kMillisecond)}, true);
  ASSERT_TRUE(tests::eventually([&] { return told().problem() == "given:0 is unplugged"; }));
  EXPECT_EQ(images(), 1u);
  EXPECT_EQ(told().left_out(), 1u);
}

TEST_F(Watching, TheNext15ImagesAreTheEmptyFieldAndAreNotSearched) {
  watch(images_from(clock.now_ns(), 60));
  ASSERT_TRUE(tests::eventually([&] { return is_watching(); }));
  EXPECT_EQ(told().background_images(), 0u) << "only the plane of the carpet";
  const auto images_to_learn = watched().learn_background();
  ASSERT_TRUE(images_to_learn) << images_to_learn.error();
  EXPECT_EQ(*images_to_learn, 15u);
  ASSERT_TRUE(tests::eventually([&] { return has_ended(); }));
  EXPECT_EQ(told().background_images(), 15u);
  EXPECT_EQ(told().background_awaited(), 0u);
  EXPECT_EQ(images(), 60u);
  EXPECT_EQ(searched, 45);
}

TEST_F(Watching, ANewPlaceBeginsWithoutABackground) {
  watch(images_from(clock.now_ns(), 2000));
  ASSERT_TRUE(tests::eventually([&] { return is_watching(); }));
  ASSERT_TRUE(watched().learn_background());
  ASSERT_TRUE(tests::eventually([&] { return told().background_images() > 0; }));
  watched().place(placed);
  ASSERT_TRUE(tests::eventually([&] { return told().background_images() == 0; }));
  EXPECT_EQ(told().background_awaited(), 0u);
  EXPECT_TRUE(tests::eventually([&] { return told().robots_size() == 1; }));
}

}  // namespace
}  // namespace robot::app
