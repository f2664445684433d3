
#include <gtest/gtest.h>

#include "robot/core/clock.h"
#include "robot/core/files.h"
#include "robot/truth/sensor/open_source.h"
#include "tests/support/temporary_folder.h"

namespace {

using robot::kSecond;
using robot::truth::open_source;

/// A folder with pictures of one pixel.
class PictureFolderTest : public testing::Test {
 protected:
  void put(std::string_view name, std::string_view bytes = "P6 1 1 255 abc") const {
    ASSERT_TRUE(robot::replace_file(folder / name, bytes));
  }
  auto open() const { return open_source("pictures:" + folder.path().string()); }

  /// Returns the times of all pictures.
  std::vector<std::uint64_t> times() const {
    std::vector<std::uint64_t> times;
    const auto source = open();
    if (!source) return times;
    for (auto picture = (*source)->next(); picture && *picture; picture = (*source)->next())
      times.push_back((*picture)->capture_ns);
    return times;
  }

  const tests::TemporaryFolder folder;
};

TEST_F(PictureFolderTest, NamesOfOtherKindsGiveThirtyPicturesASecond) {
  put("b.ppm");
  put("a.ppm");
  put("1712345678.5.ppm");
  put("notes.txt");
  EXPECT_EQ(times(), (std::vector<std::uint64_t>{kSecond, kSecond + kSecond / 30, kSecond + 2 * kSecond / 30}));
}

TEST_F(PictureFolderTest, NamesMayBeTimes) {
  put("1712345678.5.ppm");
  put("1712345679.ppm.ppm");
  EXPECT_EQ(times().front(), kSecond);
  std::filesystem::remove(folder / "1712345679.ppm.ppm");
  put("1712345678250.ppm");
  EXPECT_EQ(times(), (std::vector<std::uint64_t>{1712345678250000000, 1712345678500000000}));
}

TEST_F(PictureFolderTest, ADamagedPictureIsNamedAndTheNextOneFollows) {
  put("1.ppm", "P6 1 1 255 a");
  put("2.ppm");
  const auto source = open();
  ASSERT_TRUE(source) << source.error();
  EXPECT_EQ((*source)->next().error(), (folder / "1.ppm").string() + ": expected 3 bytes of pixels of 1x1 px, got 1");
  const auto second = (*source)->next();
  ASSERT_TRUE(second && *second);
  EXPECT_EQ((*second)->rgb, (std::vector<std::uint8_t>{'a', 'b', 'c'}));
  const auto end = (*source)->next();
  EXPECT_TRUE(end && !*end);
  EXPECT_FALSE((*source)->live());
  EXPECT_EQ((*source)->address(), "pictures:" + folder.path().string());
}

TEST_F(PictureFolderTest, AFolderWithoutPicturesIsRefused) {
  EXPECT_EQ(open().error(), folder.path().string() + ": expected pictures (*.jpg, *.jpeg, *.png, *.ppm), got none");
}

TEST(Address, OfAnOrdinaryCameraIsKnown) {
  for (const char* address : {"camera:/dev/video0", "pictures:logs/field", "camera:"})
    EXPECT_TRUE(robot::truth::is_ordinary_camera(address)) << address;
  for (const char* address : {"", "freenect:0", "cameras:1", "v4l2:/dev/video0"})
    EXPECT_FALSE(robot::truth::is_ordinary_camera(address)) << address;
}

}  // namespace
