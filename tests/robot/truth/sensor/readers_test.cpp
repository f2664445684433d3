// Readers of image files: what their writers wrote, and bad input.
#include <gtest/gtest.h>
#include <tiff.h>

#include <string>

#include "robot/truth/sensor/lzf.h"
#include "robot/truth/sensor/netpbm.h"
#include "robot/truth/sensor/pclzf.h"
#include "robot/truth/sensor/png.h"
#include "robot/truth/sensor/tiff.h"
#include "tests/robot/truth/sensor/depth_files.h"

namespace robot::truth {
namespace {

using namespace std::string_literals;
using tests::colour_image;
using tests::expect_no_beginning_is_read;
using tests::grey_image;
using tests::survive_each_flip;

/// Expects that a file of a grey image is read as it was written, and that no damage of it ends the process.
template <class Reader>
void expect_round_trip(const GreyImage& image, const std::string& bytes, const Reader& reader) {
  const Result<GreyImage> read = reader(bytes);
  ASSERT_TRUE(read) << read.error();
  EXPECT_EQ(read->width, image.width);
  EXPECT_EQ(read->height, image.height);
  EXPECT_EQ(read->values, image.values);
  expect_no_beginning_is_read(bytes, reader);
  survive_each_flip(bytes, reader);
}

template <class Reader>
void expect_round_trip(const ColourImage& image, const std::string& bytes, const Reader& reader) {
  const Result<ColourImage> read = reader(bytes);
  ASSERT_TRUE(read) << read.error();
  EXPECT_EQ(read->width, image.width);
  EXPECT_EQ(read->height, image.height);
  EXPECT_EQ(read->rgb, image.rgb);
  expect_no_beginning_is_read(bytes, reader);
  survive_each_flip(bytes, reader);
}

const GreyImage kGrey = grey_image(17, 5);
const ColourImage kColour = colour_image(9, 5);

TEST(Netpbm, ReadsWhatWasWritten) {
  expect_round_trip(kGrey, tests::pgm_of(kGrey), read_pgm);
  expect_round_trip(kGrey, tests::fakenect_pgm_of(kGrey), read_fakenect_pgm);
  expect_round_trip(kColour, tests::ppm_of(kColour), read_ppm);
}

TEST(Netpbm, TakesTheMostSignificantByteFirstAsTheFormatSays) {
  const std::string bytes = "P5\n# a comment\n 2 1\t65535\n\x01\x02\x03\x04"s;
  EXPECT_EQ(read_pgm(bytes)->values, (std::vector<std::uint16_t>{0x102, 0x304}));
  EXPECT_EQ(read_fakenect_pgm(bytes)->values, (std::vector<std::uint16_t>{0x201, 0x403}));
}

TEST(Netpbm, SaysWhatIsWrong) {
  EXPECT_EQ(read_pgm("P6 1 1 255\nabc").error(), "expected an image that begins with P5, got \"P6\"");
  EXPECT_EQ(read_pgm("P5 1 -1 255\n").error(),
            "expected width, height and greatest value behind P5, got a damaged header");
  EXPECT_EQ(read_pgm("P5 1 1 255\na").error(), "expected 2 bytes of pixels of 1x1 px, got 1");
  EXPECT_EQ(read_pgm("P5 1 1 255\nab").error(),
            "expected 16 bits per pixel (a greatest value of 256 to 65535), got 255");
  EXPECT_EQ(read_pgm("P5 4097 1 65535\n").error(), "expected an image of 1x1 to 4096x4096 px, got 4097x1");
  EXPECT_EQ(read_pgm("P5 0 1 65535\n").error(), "expected an image of 1x1 to 4096x4096 px, got 0x1");
  EXPECT_EQ(read_ppm("P6 1 1 15\nabc").error(), "expected a greatest value of 255, got 15");
}

TEST(Png, ReadsWhatWasWritten) {
  expect_round_trip(kGrey, tests::png_of(kGrey), read_png);
  expect_round_trip(kGrey, tests::png_of(kGrey, /*interlaced=*/true), read_png);
}

TEST(Png, NoFlippedBitChangesAValue) {
  std::string bytes = tests::png_of(kGrey);
  for (char& byte : bytes) {
    byte = static_cast<char>(byte ^ 4);
    const Result<GreyImage> read = read_png(bytes);
    EXPECT_TRUE(!read || read->values == kGrey.values);
    byte = static_cast<char>(byte ^ 4);
  }
}

TEST(Png, SaysWhatIsWrong) {
  EXPECT_EQ(read_png("no image").error(), "expected a PNG, got a damaged one: Not a PNG file");
  EXPECT_EQ(read_png(tests::png_of(kColour)).error(),
            "expected a PNG with 16 bits of grey per pixel, got 3 channels of 8 bits");
  const std::string bytes = tests::png_of(kGrey);
  EXPECT_EQ(read_png(bytes.substr(0, 60)).error(), "expected a PNG, got a damaged one: the file is truncated");
  EXPECT_EQ(read_png(tests::png_of(grey_image(4097, 1))).error(),
            "expected an image of 1x1 to 4096x4096 px, got 4097x1");
}

TEST(Tiff, ReadsWhatWasWritten) {
  for (const int compression : {COMPRESSION_NONE, COMPRESSION_LZW, COMPRESSION_PACKBITS, COMPRESSION_ADOBE_DEFLATE})
    for (const bool big_endian : {false, true})
      expect_round_trip(kGrey, tests::tiff_of(kGrey, compression, big_endian), read_tiff);
}

TEST(Tiff, SaysWhatIsWrong) {
  EXPECT_EQ(read_tiff("no image").error().find("expected a TIFF, got a damaged one: Not a TIFF"), 0u);
  EXPECT_EQ(read_tiff(tests::tiff_in_tiles_of(kGrey)).error(), "expected a TIFF in strips, got one in tiles");
  EXPECT_EQ(read_tiff(tests::tiff_of(grey_image(4097, 1), COMPRESSION_NONE)).error(),
            "expected an image of 1x1 to 4096x4096 px, got 4097x1");
}

TEST(Lzf, RepeatsEarlierBytes) {
  // two bytes as they are, then five from two before, then twelve from one before
  const std::string packed = "\x01"s + "ab" + "\x60\x01" + "\xe0\x03\x00"s;
  EXPECT_EQ(*unpack_lzf(packed, 19), "abababa" + std::string(12, 'a'));
  EXPECT_EQ(unpack_lzf(packed, 18).error(), "expected LZF data of 18 bytes, got fewer or more");
  EXPECT_EQ(unpack_lzf(packed, 20).error(), "expected LZF data of 20 bytes, got fewer or more");
  EXPECT_EQ(unpack_lzf("\x20\x00"s, 3).error(), "expected LZF data, got a reference to bytes before the first one");
}

TEST(Pclzf, ReadsWhatWasWritten) {
  expect_round_trip(kGrey, tests::pclzf_of(kGrey), read_pclzf_depth);
  expect_round_trip(kColour, tests::pclzf_of(kColour), read_pclzf_colour);
  const GreyImage black{64, 48, std::vector<std::uint16_t>(64 * 48)};
  expect_round_trip(black, tests::pclzf_of(black), read_pclzf_depth);
}

TEST(Pclzf, SaysWhatIsWrong) {
  EXPECT_EQ(read_pclzf_depth("PNG").error(), "expected a file that begins with PCLZF, got \"PNG\"");
  EXPECT_EQ(read_pclzf_depth("PCLZF12").error(), "expected a header of 37 bytes, got 7");
  EXPECT_EQ(read_pclzf_depth(tests::pclzf_of(kColour)).error(),
            "expected an image of the type depth16, got \"rgb24           \"");
  std::string bytes = tests::pclzf_of(kGrey);
  bytes[5] = 18;
  EXPECT_EQ(read_pclzf_depth(bytes).error(), "expected 2 bytes per pixel of 18x5 px, got 170 bytes");
  EXPECT_EQ(read_pclzf_depth(tests::pclzf_of(kGrey) + "x").error().find("expected "), 0u);
}

}  // namespace
}  // namespace robot::truth
