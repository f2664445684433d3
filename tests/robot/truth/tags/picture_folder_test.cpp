#include "robot/truth/tags/picture_folder.h"

#include <gtest/gtest.h>

#include "robot/core/files.h"
#include "tests/support/temporary_folder.h"

namespace {

using robot::kSecond;
using robot::SessionClock;
using robot::truth::tags::open_pictures;
using robot::truth::tags::time_in_name;

/// A folder with pictures of one pixel.
class PictureFolderTest : public testing::Test {
 protected:
  void put(std::string_view name, std::string_view bytes = "P6 1 1 255 abc") const {
    ASSERT_TRUE(robot::replace_file(folder / name, bytes));
  }
  auto open() const { return open_pictures("pictures:" + folder.path().string(), {}, clock); }

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
  const SessionClock clock{0};
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

TEST(TimeInName, KnowsSecondsAndWholeNumbers) {
  EXPECT_EQ(time_in_name("1712345678.250000"), 1712345678250000000u);
  EXPECT_EQ(time_in_name("1712345678250"), 1712345678250000000u);
  EXPECT_EQ(time_in_name("1712345678250001"), 1712345678250001000u);
  EXPECT_EQ(time_in_name("1712345678250001002"), 1712345678250001002u);
  for (const char* name : {"", "frame0001", "12", "1.", ".5", "1.x", "1.1234567890", "12345678901.0", "171234567825x",
                           "-712345678250", "9999999999999999999999"})
    EXPECT_FALSE(time_in_name(name)) << name;
}

TEST_F(PictureFolderTest, ADamagedPictureIsNamedAndTheNextOneFollows) {
  put("1.ppm", "P6 1 1 255 a");
  put("2.ppm");
  const auto source = open();
  ASSERT_TRUE(source) << source.error();
  EXPECT_EQ((*source)->next().error(), (folder / "1.ppm").string() + ": PPM: expected 3 bytes of pixels, got 1");
  const auto second = (*source)->next();
  ASSERT_TRUE(second && *second);
  EXPECT_EQ((*second)->rgb, (std::vector<std::uint8_t>{'a', 'b', 'c'}));
  const auto end = (*source)->next();
  EXPECT_TRUE(end && !*end);
  EXPECT_FALSE((*source)->live());
  EXPECT_EQ((*source)->address(), "pictures:" + folder.path().string());
}

TEST_F(PictureFolderTest, AFolderWithoutPicturesIsRefused) {
  EXPECT_EQ(open().error(),
            "folder " + folder.path().string() + ": expected pictures *.jpg, *.jpeg, *.png or *.ppm, got none");
}

TEST(PictureSource, OtherAddressesAreRefused) {
  const SessionClock clock{0};
  EXPECT_FALSE(open_pictures("pictures:/no/such/folder", {}, clock));
  for (const std::string address : {"", "camera:", "freenect:0"})
    EXPECT_EQ(open_pictures(address, {}, clock).error(),
              "source: expected camera:/dev/videoN or pictures:FOLDER, got '" + address + "'");
  EXPECT_TRUE(robot::truth::tags::is_picture_address("camera:/dev/video0"));
  EXPECT_FALSE(robot::truth::tags::is_picture_address("freenect:0"));
}

}  // namespace
