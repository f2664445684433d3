// Addresses of sources.
#include "robot/truth/sensor/open_source.h"

#include <gtest/gtest.h>

#include "tests/robot/truth/sensor/depth_files.h"
#include "tests/support/temporary_folder.h"

namespace robot::truth {
namespace {

TEST(OpenSource, NamesAllKindsForAnUnknownOne) {
  const std::string known =
      "expected fakenect:FOLDER, folder:FOLDER, pclzf:FOLDER, pictures:FOLDER, freenect:N, openni:N, v4l2:DEVICE, "
      "camera:DEVICE";
  EXPECT_EQ(open_source("kinect:0").error(), "source \"kinect:0\": " + known);
  EXPECT_EQ(open_source("").error(), "source \"\": " + known);
  EXPECT_EQ(open_source("folder").error(), "source \"folder\": " + known);
}

TEST(OpenSource, DescribesEachKindInALineAndNamesTheAbsentOnes) {
  const std::string lines = describe_sources();
  for (const char* address :
       {"fakenect:FOLDER", "folder:FOLDER", "pclzf:FOLDER", "freenect:N", "openni:N", "v4l2:DEVICE"})
    EXPECT_NE(lines.find("  " + std::string(address) + " "), std::string::npos) << lines;
  // an absent driver cannot be opened, and says the same
  for (const auto& [kind, package] :
       {std::pair{"freenect", "libfreenect-dev"}, std::pair{"openni", "libopenni2-dev"}}) {
    const std::string absence = std::string("not in this build, ") + package + " was missing";
    if (lines.find(absence) == std::string::npos)
      EXPECT_TRUE(open_source(std::string(kind) + ":0"));
    else
      EXPECT_EQ(open_source(std::string(kind) + ":0").error(), std::string(kind) + ": " + absence);
  }
}

TEST(OpenSource, OpensALiveSourceBeforeItsSensorIsThere) {
  const auto source = open_source("v4l2:/dev/video-of-no-machine");
  ASSERT_TRUE(source) << source.error();
  EXPECT_TRUE((*source)->live());
  EXPECT_EQ((*source)->address(), "v4l2:/dev/video-of-no-machine");
  EXPECT_EQ(
      (*source)->next().error(),
      "v4l2:/dev/video-of-no-machine: camera /dev/video-of-no-machine: expected a video device, got No such file or "
      "directory");
}

TEST(OpenSource, ReadsTheCameraFileOfALiveSourceAtOnce) {
  const tests::TemporaryFolder folder;
  const std::string file = folder / "d435.json";
  tests::write_file(file, R"({"focal_x": "wide"})");
  EXPECT_EQ(open_source("v4l2:/dev/video0@" + file).error(),
            file + ": \"focal_x\" must be a number from 1 to 100000, got \"wide\"");
  tests::write_file(file, R"({"focal_x": 384})");
  EXPECT_TRUE(open_source("v4l2:/dev/video0@" + file));
  EXPECT_FALSE(open_source("v4l2:/dev/video0@" + file + ".none"));
}

}  // namespace
}  // namespace robot::truth
