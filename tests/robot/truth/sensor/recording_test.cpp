// Folders of recorded images, through the address of each.
#include <gtest/gtest.h>
#include <tiff.h>

#include <memory>
#include <string>

#include "robot/truth/sensor/fakenect.h"
#include "robot/truth/sensor/kinect.h"
#include "robot/truth/sensor/open_source.h"
#include "tests/robot/truth/sensor/depth_files.h"
#include "tests/support/temporary_folder.h"

namespace robot::truth {
namespace {

using tests::colour_image;
using tests::grey_image;

struct RecordingTest : ::testing::Test {
  void write(const std::string& name, const std::string& bytes) { tests::write_file(folder / name, bytes); }

  std::string address(const std::string& kind) const { return kind + ":" + folder.path().string(); }

  std::unique_ptr<DepthSource> open(const std::string& kind) {
    Result<std::unique_ptr<DepthSource>> source = open_source(address(kind));
    EXPECT_TRUE(source) << source.error();
    return source ? *std::move(source) : nullptr;
  }

  /// Returns the error without the folder, or "" if there is none.
  template <class T>
  std::string error_of(const Result<T>& result) const {
    if (result) return "";
    std::string error = result.error();
    const std::string path = folder.path().string() + "/";
    if (const std::size_t at = error.find(path); at != std::string::npos) error.erase(at, path.size());
    return error;
  }

  /// Expects an image, and returns it.
  static DepthFrame next(DepthSource& source) {
    Result<std::optional<DepthFrame>> frame = source.next();
    EXPECT_TRUE(frame) << frame.error();
    EXPECT_TRUE(frame && *frame) << "the recording is at its end";
    return frame && *frame ? **std::move(frame) : DepthFrame{};
  }

  static void expect_end(DepthSource& source) {
    for (int i = 0; i < 2; ++i) {
      const auto end = source.next();
      ASSERT_TRUE(end) << end.error();
      EXPECT_FALSE(*end);
    }
  }

  tests::TemporaryFolder folder;
  const GreyImage grey = grey_image(64, 48, kNoDisparity);
};

using FakenectFolderTest = RecordingTest;
using ImageFolderTest = RecordingTest;
using PclzfFolderTest = RecordingTest;

TEST_F(FakenectFolderTest, DeliversItsImagesWithTimesAndColours) {
  write("INDEX.txt",
        "r-1000000000.000000-1.ppm\na-1000000000.100000-1.dump\nd-1000000000.020000-2.pgm\nd-1000000001.000000-3."
        "pgm\n\n");
  const ColourImage colour = colour_image(64, 48);
  write("r-1000000000.000000-1.ppm", tests::ppm_of(colour));
  write("d-1000000000.020000-2.pgm", tests::fakenect_pgm_of(grey));
  write("d-1000000001.000000-3.pgm", tests::fakenect_pgm_of(grey));

  const auto source = open("fakenect");
  EXPECT_EQ(source->address(), address("fakenect"));
  EXPECT_FALSE(source->live());
  const DepthFrame first = next(*source);
  EXPECT_EQ(first.capture_ns, 1000000000'020000000u);
  EXPECT_EQ(first.intrinsics, kinect_intrinsics(64, 48));
  EXPECT_EQ(first.unit, 0.001);
  ASSERT_EQ(first.depth.size(), grey.values.size());
  for (std::size_t i = 0; i < first.depth.size(); ++i) ASSERT_EQ(first.depth[i], depth_of_disparity(grey.values[i]));
  EXPECT_EQ(first.rgb, registered_colours(first, colour));
  // the colour image is a second older than this one
  EXPECT_TRUE(next(*source).rgb.empty());
  expect_end(*source);
}

TEST_F(FakenectFolderTest, ReportsEachDamagedImageOnceAndGoesOn) {
  write("INDEX.txt",
        "d-1000000000.1-1.pgm\nd-1000000000.2-2.pgm\nd-1000000000.3-3.pgm\nd-10000\n../d-1000000000.4-4.pgm\n"
        "d-/1000000000.4-4.pgm\nd-1000000000.5-5.pgm\n");
  write("d-1000000000.2-2.pgm", tests::fakenect_pgm_of(grey).substr(0, 5000));
  write("d-1000000000.3-3.pgm", tests::pgm_of(grey));
  write("d-1000000000.5-5.pgm", tests::fakenect_pgm_of(grey));
  const auto source = open("fakenect");
  EXPECT_EQ(error_of(source->next()), "cannot read d-1000000000.1-1.pgm: No such file or directory");
  EXPECT_EQ(error_of(source->next()), "d-1000000000.2-2.pgm: expected 6144 bytes of pixels of 64x48 px, got 4985");
  EXPECT_EQ(error_of(source->next()),
            "d-1000000000.3-3.pgm: expected disparities of 11 bits (0 to 2047), got 11265 in pixel 0");
  const std::string expected = "INDEX.txt: expected a name such as d-1294851097.453589-2279103905.pgm, got ";
  EXPECT_EQ(error_of(source->next()), expected + "\"d-10000\"");
  EXPECT_EQ(error_of(source->next()), expected + "\"../d-1000000000.4-4.pgm\"");
  EXPECT_EQ(error_of(source->next()), expected + "\"d-/1000000000.4-4.pgm\"");
  EXPECT_EQ(next(*source).capture_ns, 1000000000'500000000u);
  expect_end(*source);
}

TEST_F(FakenectFolderTest, NamesAMissingOrEmptyIndex) {
  EXPECT_EQ(error_of(open_source(address("fakenect"))),
            "expected a recording of fakenect-record: cannot read INDEX.txt: No such file or directory");
  write("INDEX.txt", "\n\n");
  EXPECT_EQ(error_of(open_source(address("fakenect"))), "INDEX.txt: expected names of depth images, got none");
}

TEST_F(FakenectFolderTest, DeliversImagesWithoutAMeasurement) {
  write("INDEX.txt", "d-1000000000.1-1.pgm\nd-1000000000.2-2.pgm\n");
  write("d-1000000000.1-1.pgm", tests::fakenect_pgm_of({8, 8, std::vector<std::uint16_t>(64, kNoDisparity)}));
  write("d-1000000000.2-2.pgm", tests::fakenect_pgm_of({8, 8, std::vector<std::uint16_t>(64, 0)}));
  const auto source = open("fakenect");
  EXPECT_EQ(next(*source).depth, std::vector<std::uint16_t>(64));
  EXPECT_EQ(next(*source).depth.size(), 64u);
}

TEST_F(ImageFolderTest, DeliversAllFormatsInTheOrderOfTheirNames) {
  write("3.TIFF", tests::tiff_of(grey, COMPRESSION_LZW));
  write("1.png", tests::png_of(grey));
  write("2.pgm", tests::pgm_of(grey));
  write("4.tif", tests::tiff_of(grey, COMPRESSION_NONE));
  write("notes.txt", "not an image");
  const auto source = open("folder");
  for (std::uint64_t i = 0; i < 4; ++i) {
    const DepthFrame frame = next(*source);
    EXPECT_EQ(frame.depth, grey.values) << i;
    EXPECT_EQ(frame.intrinsics, kinect_intrinsics(64, 48));
    EXPECT_EQ(frame.unit, 0.001);
    EXPECT_TRUE(frame.rgb.empty());
    EXPECT_NEAR(static_cast<double>(frame.capture_ns), static_cast<double>(i) * 1e9 / 30, 1) << "30 a second";
  }
  expect_end(*source);
}

TEST_F(ImageFolderTest, TakesTimesFromNames) {
  write("1305031102.160407.png", tests::png_of(grey));
  EXPECT_EQ(next(*open("folder")).capture_ns, 1305031102'160407000u);
}

TEST_F(ImageFolderTest, TakesACameraFile) {
  write("1305031102.160407.png", tests::png_of(grey));
  write("camera.json", R"({"focal_x": 60, "unit": 0.0002, "capture_ns": ["7"]})");
  const DepthFrame frame = next(*open("folder"));
  EXPECT_EQ(frame.intrinsics.focal_x, 60);
  EXPECT_EQ(frame.unit, 0.0002);
  EXPECT_EQ(frame.capture_ns, 7u);
}

TEST_F(ImageFolderTest, TakesTheRateOfACameraFile) {
  write("a.png", tests::png_of(grey));
  write("b.png", tests::png_of(grey));
  write("camera.json", R"({"rate": 8})");
  const auto source = open("folder");
  EXPECT_EQ(next(*source).capture_ns, 0u);
  EXPECT_EQ(next(*source).capture_ns, 125'000'000u);
}

TEST_F(ImageFolderTest, RefusesAWrongCameraFile) {
  write("a.png", tests::png_of(grey));
  write("camera.json", R"({"focal_x": NaN})");
  EXPECT_EQ(error_of(open_source(address("folder"))), "camera.json: expected JSON, got something else");
  write("camera.json", R"({"capture_ns": ["1", "2"]})");
  EXPECT_EQ(error_of(open_source(address("folder"))), "camera.json: expected \"capture_ns\" of 1 images, got 2");
  write("camera.json", R"({"width": 640, "height": 480})");
  EXPECT_EQ(error_of(open("folder")->next()),
            "a.png: expected 640x480 px, for which the camera file is made, got 64x48");
}

TEST_F(ImageFolderTest, ReportsEachDamagedImageOnceAndGoesOn) {
  write("a.png", tests::png_of(colour_image(4, 4)));
  write("b.png", tests::png_of(grey).substr(0, 500));
  write("c.pgm", "");
  write("d.tiff", "no image");
  write("e.png", tests::png_of(grey));
  const auto source = open("folder");
  EXPECT_EQ(error_of(source->next()), "a.png: expected a PNG with 16 bits of grey per pixel, got 3 channels of 8 bits");
  EXPECT_EQ(error_of(source->next()), "b.png: expected a PNG, got a damaged one: the file is truncated");
  EXPECT_EQ(error_of(source->next()), "c.pgm: expected an image that begins with P5, got \"\"");
  EXPECT_EQ(error_of(source->next()).find("d.tiff: expected a TIFF, got a damaged one: "), 0u);
  EXPECT_EQ(next(*source).depth, grey.values);
  expect_end(*source);
}

TEST_F(ImageFolderTest, NamesAnEmptyOrMissingFolder) {
  EXPECT_NE(open_source(address("folder")).error().find(": expected images (*.png, *.pgm, *.tif, *.tiff), got none"),
            std::string::npos);
  EXPECT_NE(open_source(address("folder") + "/none").error().find("No such file"), std::string::npos);
}

TEST_F(PclzfFolderTest, DeliversItsImagesWithTimesAndColours) {
  const ColourImage colour = colour_image(64, 48);
  write("frame_20121214T142255.814212_depth.pclzf", tests::pclzf_of(grey));
  write("frame_20121214T142255.814212_rgb.pclzf", tests::pclzf_of(colour));
  write("frame_20121214T142255.814212.xml", tests::pcl_xml(52.5, 31, 25));
  write("other_depth.pclzf", tests::pclzf_of(grey));
  write("other.xml", tests::pcl_xml(52.5, 31, 25));
  const auto source = open("pclzf");
  const DepthFrame first = next(*source);
  EXPECT_EQ(first.capture_ns, 1355494975'814212000u);
  EXPECT_EQ(first.intrinsics, (Intrinsics{64, 48, 52.5, 52.5, 31, 25, 0.075}));
  EXPECT_EQ(first.unit, 0.002);
  EXPECT_EQ(first.depth, grey.values);
  EXPECT_EQ(first.rgb, colour.rgb);
  EXPECT_TRUE(next(*source).rgb.empty());
  expect_end(*source);
}

TEST_F(PclzfFolderTest, ReportsEachDamagedImageOnceAndGoesOn) {
  write("a_depth.pclzf", tests::pclzf_of(grey));  // no a.xml
  write("b_depth.pclzf", tests::pclzf_of(grey));
  write("b.xml", "<depth>");
  write("c_depth.pclzf", tests::pclzf_of(colour_image(64, 48)));
  write("d_depth.pclzf", tests::pclzf_of(grey));
  write("d.xml", tests::pcl_xml(52.5, 32, 24));
  write("d_rgb.pclzf", tests::pclzf_of(colour_image(32, 48)));
  write("e_depth.pclzf", tests::pclzf_of(grey));
  write("e.xml", tests::pcl_xml(52.5, 32, 24));
  const auto source = open("pclzf");
  EXPECT_EQ(error_of(source->next()), "cannot read a.xml: No such file or directory");
  EXPECT_EQ(error_of(source->next()), "b.xml: expected intrinsics within <depth> and </depth>, got none");
  EXPECT_EQ(error_of(source->next()), "c_depth.pclzf: expected an image of the type depth16, got \"rgb24           \"");
  EXPECT_EQ(error_of(source->next()), "d_rgb.pclzf: expected 64x48 px as its depth image, got 32x48");
  EXPECT_EQ(next(*source).depth, grey.values);
  expect_end(*source);
}

TEST_F(PclzfFolderTest, NamesAnEmptyFolder) {
  EXPECT_NE(open_source(address("pclzf")).error().find(": expected images (*_depth.pclzf), got none"),
            std::string::npos);
}

}  // namespace
}  // namespace robot::truth
