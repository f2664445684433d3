#include "robot/truth/tags/picture_codec.h"

#include <gtest/gtest.h>
#include <png.h>

#include <cstdlib>

#include "tests/support/jpeg_pictures.h"

namespace {

using robot::truth::tags::black_picture;
using robot::truth::tags::Damage;
using robot::truth::tags::decode_jpeg_picture;
using robot::truth::tags::decode_picture;
using robot::truth::tags::Picture;
using robot::truth::tags::picture_of_yuyv;
using robot::truth::tags::PictureSize;

/// Returns a picture whose colours change slowly, as JPEG likes it.
Picture gradient() {
  Picture picture = black_picture({48, 32});
  for (std::size_t i = 0; i < picture.rgb.size() / 3; ++i) {
    picture.rgb[3 * i] = static_cast<std::uint8_t>(5 * (i % 48));
    picture.rgb[3 * i + 1] = static_cast<std::uint8_t>(7 * (i / 48));
    picture.rgb[3 * i + 2] = 128;
  }
  return picture;
}

std::string ppm_of(const Picture& picture) {
  std::string ppm =
      "P6 # a comment\n" + std::to_string(picture.size.width) + " " + std::to_string(picture.size.height) + "\n255\n";
  ppm.append(picture.rgb.begin(), picture.rgb.end());
  return ppm;
}

std::string png_of(const Picture& picture, png_uint_32 format = PNG_FORMAT_RGB) {
  png_image image{};
  image.version = PNG_IMAGE_VERSION;
  image.width = static_cast<png_uint_32>(picture.size.width);
  image.height = static_cast<png_uint_32>(picture.size.height);
  image.format = format;
  png_alloc_size_t size = 0;
  png_image_write_to_memory(&image, nullptr, &size, 0, picture.rgb.data(), 0, nullptr);
  std::string png(size, '\0');
  png_image_write_to_memory(&image, png.data(), &size, 0, picture.rgb.data(), 0, nullptr);
  return png;
}

TEST(PictureCodec, PpmAndPngAreExact) {
  const Picture picture = gradient();
  for (const std::string& bytes : {ppm_of(picture), png_of(picture)}) {
    const auto decoded = decode_picture(bytes);
    ASSERT_TRUE(decoded) << decoded.error();
    EXPECT_EQ(decoded->size, picture.size);
    EXPECT_EQ(decoded->rgb, picture.rgb);
  }
}

TEST(PictureCodec, AGreyPngIsAPicture) {
  Picture grey{{4, 1}, {0, 50, 100, 255}, 0};
  const auto decoded = decode_picture(png_of(grey, PNG_FORMAT_GRAY));
  ASSERT_TRUE(decoded) << decoded.error();
  EXPECT_EQ(decoded->rgb, (std::vector<std::uint8_t>{0, 0, 0, 50, 50, 50, 100, 100, 100, 255, 255, 255}));
}

TEST(PictureCodec, JpegIsClose) {
  const Picture picture = gradient();
  const auto decoded = decode_picture(tests::jpeg_of(picture, 95));
  ASSERT_TRUE(decoded) << decoded.error();
  ASSERT_EQ(decoded->size, picture.size);
  for (std::size_t i = 0; i < picture.rgb.size(); ++i) EXPECT_LT(std::abs(decoded->rgb[i] - picture.rgb[i]), 12) << i;
}

TEST(PictureCodec, EveryTruncatedFileIsRefused) {
  constexpr std::size_t kEndOfPng = 12;  // the library does not read the last part, which is empty
  const Picture picture = gradient();
  const std::string ppm = ppm_of(picture), jpeg = tests::jpeg_of(picture, 75), png = png_of(picture);
  for (std::size_t n = 0; n < ppm.size(); ++n) EXPECT_FALSE(decode_picture(ppm.substr(0, n))) << n;
  for (std::size_t n = 0; n < jpeg.size(); ++n) EXPECT_FALSE(decode_picture(jpeg.substr(0, n))) << n;
  for (std::size_t n = 0; n + kEndOfPng < png.size(); ++n) EXPECT_FALSE(decode_picture(png.substr(0, n))) << n;
}

TEST(PictureCodec, FlippedBytesGiveAPictureOrASentence) {
  const Picture picture = gradient();
  for (const std::string& bytes : {ppm_of(picture).substr(0, 40), tests::jpeg_of(picture, 75), png_of(picture)})
    for (std::size_t n = 0; n < bytes.size(); ++n) {
      std::string flipped = bytes;
      flipped[n] = static_cast<char>(~flipped[n]);
      const auto decoded = decode_picture(flipped);
      EXPECT_TRUE(decoded || !decoded.error().empty());
    }
}

TEST(PictureCodec, ACameraFrameMayBeDamaged) {
  const std::string jpeg = tests::jpeg_of(gradient(), 75);
  const std::string cut = jpeg.substr(0, jpeg.size() - 2);
  EXPECT_FALSE(decode_jpeg_picture(cut, Damage::refused));
  EXPECT_TRUE(decode_jpeg_picture(cut, Damage::accepted));
  EXPECT_FALSE(decode_jpeg_picture(jpeg.substr(0, 20), Damage::accepted));
}

TEST(PictureCodec, SaysWhatIsWrong) {
  EXPECT_EQ(decode_picture("").error(), "expected a JPEG, PNG or PPM (P6) picture, got something else");
  EXPECT_EQ(decode_picture("P5 1 1 255 x").error(), "expected a JPEG, PNG or PPM (P6) picture, got something else");
  EXPECT_EQ(decode_picture("P6 5000 1 255 ").error(), "PPM: expected 1 .. 4096 px a side, got 5000x1");
  EXPECT_EQ(decode_picture("P6 2 -1 255 ").error(), "PPM: expected 1 .. 4096 px a side, got 2x-1");
  EXPECT_EQ(decode_picture("P6 2 1 65535 ").error(), "PPM: expected 255 as greatest value, got 65535");
  EXPECT_EQ(decode_picture("P6 2 1 255 abc").error(), "PPM: expected 6 bytes of pixels, got 3");
}

TEST(PictureCodec, YuyvOfKnownColours) {
  // white, black; red, red
  const auto picture = picture_of_yuyv(std::string("\xff\x80\x00\x80\x4c\x55\x4c\xff", 8), {4, 1});
  ASSERT_TRUE(picture) << picture.error();
  const std::vector<std::uint8_t> expected{255, 255, 255, 0, 0, 0, 254, 0, 0, 254, 0, 0};
  for (std::size_t i = 0; i < expected.size(); ++i) EXPECT_NEAR(picture->rgb[i], expected[i], 1) << i;
  EXPECT_EQ(picture_of_yuyv("1234567", {4, 1}).error(), "YUYV: expected 8 bytes for an even width of 4 px, got 7");
  EXPECT_FALSE(picture_of_yuyv("123456", {3, 1}));
}

}  // namespace
