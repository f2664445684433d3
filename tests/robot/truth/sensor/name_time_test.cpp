// Times in the names of image files.
#include "robot/truth/sensor/name_time.h"

#include <gtest/gtest.h>

namespace robot::truth {
namespace {

TEST(NameTime, ReadsSecondsWithAFraction) {
  EXPECT_EQ(time_in_name("1305031102.160407.png"), 1305031102'160407000u);
  EXPECT_EQ(time_in_name("d-1294851097.453589-2279103905.pgm"), 1294851097'453589000u);
  EXPECT_EQ(time_in_name("depth_1305031102.5.tiff"), 1305031102'500000000u);
  EXPECT_EQ(time_in_name("1305031102.1234567899.png"), 1305031102'123456789u);
}

TEST(NameTime, ReadsMillisecondsMicrosecondsAndNanoseconds) {
  EXPECT_EQ(time_in_name("a1305031102160.png"), 1305031102'160000000u);
  EXPECT_EQ(time_in_name("1305031102160407.png"), 1305031102'160407000u);
  EXPECT_EQ(time_in_name("1305031102160407123.png"), 1305031102'160407123u);
}

TEST(NameTime, ReadsDatesAsUtc) {
  EXPECT_EQ(time_in_name("frame_20121214T142255.814212_depth.tiff"), 1355494975'814212000u);
  EXPECT_EQ(time_in_name("20240229T000000"), 1709164800'000000000u);
}

TEST(NameTime, ReturnsNothingForOtherNumbers) {
  for (const char* name : {"", "depth.png", "000123.png", "1305031102.png", "20121214.png", "20121314T142255.png",
                           "20230229T000000.png", "20121214T242255.png", "0000000000017.png", "19691231T235959.png",
                           "99991231T235959.png", "13050311021604071234.png", "1305031102..png"})
    EXPECT_EQ(time_in_name(name), std::nullopt) << name;
}

}  // namespace
}  // namespace robot::truth
