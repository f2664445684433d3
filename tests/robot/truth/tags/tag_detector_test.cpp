#include "robot/truth/tags/tag_detector.h"

#include <gtest/gtest.h>

#include "robot/truth/tags/tag_watcher.h"
#include "tests/support/camera_above.h"

namespace {

using robot::truth::DepthFrame;
using robot::truth::tags::sees_tags;
using robot::truth::tags::TagDetector;

TEST(TagDetector, ABuildWithoutTheLibrarySaysSo) {
  if (sees_tags()) GTEST_SKIP() << "this build has libapriltag";
  const auto detector = TagDetector::create({});
  ASSERT_FALSE(detector);
  EXPECT_EQ(detector.error(),
            "printed tags are not in this build: install libapriltag-dev, then configure and build again");
  EXPECT_NE(robot::truth::tags::describe_tags().find("printed tags are not in this build"), std::string::npos);
}

TEST(TagDetector, HelpNamesTheFamilies) {
  EXPECT_EQ(robot::truth::tags::describe_tags().find("tag36h11") != std::string::npos, sees_tags());
}

TEST(TagDetector, AFamilyThatIsMistakenEasilyIsRefused) {
  if (!sees_tags()) GTEST_SKIP() << "this build has no libapriltag";
  EXPECT_EQ(TagDetector::create({.family = "tag16h5"}).error(),
            "tag family: expected tag36h11, tag36h10 or tag25h9, got 'tag16h5'");
}

TEST(TagDetector, BlankAndTinyPicturesHaveNoTags) {
  if (!sees_tags()) GTEST_SKIP() << "this build has no libapriltag";
  auto detector = TagDetector::create({});
  ASSERT_TRUE(detector);
  for (const int side : {1, 2, 7, 31, 32, 33, 200}) {
    DepthFrame picture = tests::black_picture({side, side});
    EXPECT_TRUE(detector->detect(picture).empty()) << side;
    picture.rgb.assign(picture.rgb.size(), 255);
    EXPECT_TRUE(detector->detect(picture).empty()) << side;
    for (std::size_t i = 0; i < picture.rgb.size(); ++i)
      picture.rgb[i] = static_cast<std::uint8_t>(i * 2654435761u >> 24);
    EXPECT_TRUE(detector->detect(picture).empty()) << side;
  }
}

}  // namespace
