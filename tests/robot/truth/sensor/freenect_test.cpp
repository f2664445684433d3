// The driver of the Kinect, against Debian's fakenect: a libfreenect whose sensor is a recording. This program loads it
// instead of the real library.
#include <gtest/gtest.h>

#include <array>
#include <cstdlib>
#include <filesystem>
#include <string>

#include "robot/core/clock.h"
#include "robot/truth/sensor/freenect_driver.h"
#include "robot/truth/sensor/open_source.h"
#include "tests/robot/truth/sensor/depth_files.h"
#include "tests/support/real_data.h"
#include "tests/support/temporary_folder.h"

namespace robot::truth {
namespace {

constexpr std::array<const char*, 2> kDepthNames = {"d-1294851097.453589-2279103905.pgm",
                                                    "d-1294851097.486922-2281103905.pgm"};

/// Makes a recording with a colour image and the depth images of a real one, or made ones where FORESIGHT_DATA is unset.
void make_recording(const std::filesystem::path& folder) {
  const std::string colour = "r-1294851097.450000-2279000000.ppm";
  std::string index = colour + "\n";
  tests::write_file(folder / colour, tests::ppm_of(tests::colour_image(640, 480)));
  for (const char* name : kDepthNames) {
    index += std::string(name) + "\n";
    if (const auto real = tests::real_data(std::string("depth/fakenect_nyu/") + name))
      std::filesystem::copy_file(*real, folder / name);
    else
      tests::write_file(folder / name, tests::fakenect_pgm_of(tests::grey_image(640, 480, 2047)));
  }
  tests::write_file(folder / "INDEX.txt", index);
}

// One test, because fakenect reads one recording in a process.
TEST(Freenect, DeliversTheImagesThatTheReaderOfTheirFilesDelivers) {
  const tests::TemporaryFolder folder;
  make_recording(folder.path());
  setenv("FAKENECT_PATH", folder.path().c_str(), 1);
  const auto recording = open_source("fakenect:" + folder.path().string());
  ASSERT_TRUE(recording) << recording.error();
  const auto driver = freenect_driver(0);
  const Result<void> opened = driver->open();
  ASSERT_TRUE(opened) << opened.error();

  std::uint64_t last_ns = system_ns() - kSecond;
  for (std::size_t image = 0; image < kDepthNames.size(); ++image) {
    const auto expected = (*recording)->next();
    ASSERT_TRUE(expected && *expected);
    const auto frame = driver->newest(1000);
    ASSERT_TRUE(frame) << frame.error();
    ASSERT_TRUE(*frame);
    EXPECT_EQ((*frame)->depth, (*expected)->depth);
    EXPECT_FALSE((*frame)->rgb.empty());
    EXPECT_EQ((*frame)->rgb, (*expected)->rgb);
    EXPECT_EQ((*frame)->intrinsics, (*expected)->intrinsics);
    // the capture time is of this moment, not of the recording's
    EXPECT_GT((*frame)->capture_ns, last_ns);
    EXPECT_LT((*frame)->capture_ns, system_ns() + kSecond);
    last_ns = (*frame)->capture_ns;
  }
  EXPECT_EQ(driver->newest(1000).error(), "the Kinect is gone");
  driver->close();
}

TEST(Freenect, NamesAnAbsentSensor) {
  EXPECT_EQ(freenect_driver(7)->open().error(), "expected a Kinect with the number 7, found 1 (from 0 on)");
  EXPECT_EQ(open_source("freenect:one").error(),
            "freenect:one: expected the number of a Kinect, from 0 on, got \"one\"");
  EXPECT_FALSE(open_source("freenect:-1"));
  EXPECT_FALSE(open_source("freenect:0x"));
}

}  // namespace
}  // namespace robot::truth
