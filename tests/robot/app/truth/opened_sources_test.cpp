#include "robot/app/truth/opened_sources.h"

#include <gtest/gtest.h>

#include <fstream>

#include "tests/support/temporary_folder.h"

namespace robot::app {
namespace {

constexpr std::uint64_t kCaptureNs = 1'700'000'000'500'000'000;

/// Writes a depth image of 2x2 px: a PGM of 16 bits.
void write_image(const std::filesystem::path& file) {
  std::ofstream(file, std::ios::binary) << "P5 2 2 65535\n" << std::string(8, '\x04');
}

TEST(OpenedSources, AfterADamagedFirstImageTheClockIsThatOfTheNextOne) {
  tests::TemporaryFolder folder;
  std::ofstream(folder.path() / "1700000000.400000.pgm") << "no image";
  write_image(folder.path() / "1700000000.500000.pgm");
  const auto sources = OpenedSources::open({}, {"folder:" + folder.path().string()});
  ASSERT_TRUE(sources) << sources.error();
  EXPECT_GE(sources->clock().now_ns(), kCaptureNs);
  EXPECT_LT(sources->clock().now_ns(), kCaptureNs + 3600 * kSecond);
}

}  // namespace
}  // namespace robot::app
