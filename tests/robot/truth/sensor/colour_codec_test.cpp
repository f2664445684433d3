#include "robot/truth/sensor/colour_codec.h"

#include <gtest/gtest.h>
#include <png.h>

#include <cstdlib>

#include "tests/support/jpeg_pictures.h"

namespace {

using robot::truth::colour_of_yuyv;
using robot::truth::ColourImage;
using robot::truth::Damage;
using robot::truth::read_colour;
using robot::truth::read_jpeg;

/// Returns a picture whose colours change slowly, as JPEG likes it.
ColourImage gradient() {
  ColourImage picture{48, 32, std::vector<std::uint8_t>(3 * 48 * 32)};
  for (std::size_t i = 0; i < picture.rgb.size() / 3; ++i) {
    picture.rgb[3 * i] = static_cast<std::uint8_t>(5 * (i % 48));
    picture.rgb[3 * i + 1] = static_cast<std::uint8_t>(7 * (i / 48));
    picture.rgb[3 * i + 2] = 128;
  }
  return picture;
}

std::string ppm_of(const ColourImage& picture) {
  std::string ppm =
      "P6 # a comment\n" + std::to_string(picture.width) + " " + std::to_string(picture.height) + "\n255\n";
  ppm.append(picture.rgb.begin(), picture.rgb.end());
  return ppm;
}

std::string png_of(const ColourImage& picture, png_uint_32 format = PNG_FORMAT_RGB) {
  png_image image{};
  image.version = PNG_IMAGE_VERSION;
  image.width = static_cast<png_uint_32>(picture.width);
  image.height = static_cast<png_uint_32>(picture.height);
  image.format = format;
  png_alloc_size_t size = 0;
  png_image_write_to_memory(&image, nullptr, &size, 0, picture.rgb.data(), 0, nullptr);
  std::string png(size, '\0');
  png_image_write_to_memory(&image, png.data(), &size, 0, picture.rgb.data(), 0, nullptr);
  return png;
}

TEST(ColourCodec, PpmAndPngAreExact) {
  const ColourImage picture = gradient();
  for (const std::string& bytes : {ppm_of(picture), png_of(picture)}) {
    const auto decoded = read_colour(bytes);
    ASSERT_TRUE(decoded) << decoded.error();
    EXPECT_EQ(decoded->width, picture.width);
    EXPECT_EQ(decoded->height, picture.height);
    EXPECT_EQ(decoded->rgb, picture.rgb);
  }
}

TEST(ColourCodec, AGreyPngIsAPicture) {
  const ColourImage grey{4, 1, {0, 50, 100, 255}};
  const auto decoded = read_colour(png_of(grey, PNG_FORMAT_GRAY));
  ASSERT_TRUE(decoded) << decoded.error();
  EXPECT_EQ(decoded->rgb, (std::vector<std::uint8_t>{0, 0, 0, 50, 50, 50, 100, 100, 100, 255, 255, 255}));
}

TEST(ColourCodec, JpegIsClose) {
  const ColourImage picture = gradient();
  const auto decoded = read_colour(tests::jpeg_of(picture, 95));
  ASSERT_TRUE(decoded) << decoded.error();
  ASSERT_EQ(decoded->rgb.size(), picture.rgb.size());
  for (std::size_t i = 0; i < picture.rgb.size(); ++i) EXPECT_LT(std::abs(decoded->rgb[i] - picture.rgb[i]), 12) << i;
}

TEST(ColourCodec, EveryTruncatedFileIsRefused) {
  constexpr std::size_t kEndOfPng = 12;  // the library does not read the last part, which is empty
  const ColourImage picture = gradient();
  const std::string ppm = ppm_of(picture), jpeg = tests::jpeg_of(picture, 75), png = png_of(picture);
  for (std::size_t n = 0; n < ppm.size(); ++n) EXPECT_FALSE(read_colour(ppm.substr(0, n))) << n;
  for (std::size_t n = 0; n < jpeg.size(); ++n) EXPECT_FALSE(read_colour(jpeg.substr(0, n))) << n;
  for (std::size_t n = 0; n + kEndOfPng < png.size(); ++n) EXPECT_FALSE(read_colour(png.substr(0, n))) << n;
}

TEST(ColourCodec, FlippedBytesGiveAPictureOrASentence) {
  const ColourImage picture = gradient();
  for (const std::string& bytes : {ppm_of(picture).substr(0, 40), tests::jpeg_of(picture, 75), png_of(picture)})
    for (std::size_t n = 0; n < bytes.size(); ++n) {
      std::string flipped = bytes;
      flipped[n] = static_cast<char>(~flipped[n]);
      const auto decoded = read_colour(flipped);
      EXPECT_TRUE(decoded || !decoded.error().empty());
    }
}

TEST(ColourCodec, ACameraFrameMayBeDamaged) {
  const std::string jpeg = tests::jpeg_of(gradient(), 75);
  const std::string cut = jpeg.substr(0, jpeg.size() - 2);
  EXPECT_FALSE(read_jpeg(cut, Damage::refused));
  EXPECT_TRUE(read_jpeg(cut, Damage::accepted));
  EXPECT_FALSE(read_jpeg(jpeg.substr(0, 20), Damage::accepted));
}

TEST(ColourCodec, SaysWhatIsWrong) {
  EXPECT_EQ(read_colour("").error(), "expected a JPEG, PNG or PPM (P6) picture, got something else");
  EXPECT_EQ(read_colour("P5 1 1 255 x").error(), "expected a JPEG, PNG or PPM (P6) picture, got something else");
  EXPECT_EQ(read_colour("P6 2 1 255 abc").error(), "expected 6 bytes of pixels of 2x1 px, got 3");
}

TEST(ColourCodec, YuyvOfKnownColours) {
  // white, black; red, red
  const auto picture = colour_of_yuyv(std::string("\xff\x80\x00\x80\x4c\x55\x4c\xff", 8), 4, 1);
  ASSERT_TRUE(picture) << picture.error();
  const std::vector<std::uint8_t> expected{255, 255, 255, 0, 0, 0, 254, 0, 0, 254, 0, 0};
  for (std::size_t i = 0; i < expected.size(); ++i) EXPECT_NEAR(picture->rgb[i], expected[i], 1) << i;
  EXPECT_EQ(colour_of_yuyv("1234567", 4, 1).error(), "YUYV: expected 8 bytes for an even width of 4 px, got 7");
  EXPECT_FALSE(colour_of_yuyv("123456", 3, 1));
}

}  // namespace
