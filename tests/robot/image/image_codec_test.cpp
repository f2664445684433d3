#include "robot/image/image_codec.h"

#include <gtest/gtest.h>

#include <cstdlib>
#include <random>

namespace robot::image {
namespace {

/// A smooth picture, which a JPEG of good quality keeps almost unchanged.
std::string gradient(int width, int height) {
  std::string yuyv;
  for (int y = 0; y < height; ++y)
    for (int x = 0; x < width; ++x) {
      yuyv.push_back(static_cast<char>(40 + 160 * x / width));
      yuyv.push_back(static_cast<char>(x % 2 == 0 ? 80 + 90 * y / height : 190 - 90 * y / height));
    }
  return yuyv;
}

int difference(char a, char b) { return std::abs(static_cast<unsigned char>(a) - static_cast<unsigned char>(b)); }

TEST(Jpeg, ReturnsItsSizeWithoutDecoding) {
  const Result<std::string> jpeg = encode_jpeg(gradient(320, 240), 320, 240, {.width = 160});
  ASSERT_TRUE(jpeg);
  const Result<ImageSize> size = size_of_jpeg(*jpeg);
  ASSERT_TRUE(size) << size.error();
  EXPECT_EQ(size->width, 160);
  EXPECT_EQ(size->height, 120);
  EXPECT_FALSE(size_of_jpeg("no picture"));
  EXPECT_FALSE(size_of_jpeg(""));
}

TEST(Jpeg, DecodesToAlmostTheSamePicture) {
  const std::string picture = gradient(320, 240);
  const Result<std::string> jpeg = encode_jpeg(picture, 320, 240, {.width = 0, .quality = 95});
  ASSERT_TRUE(jpeg);
  EXPECT_LT(jpeg->size(), picture.size() / 8);
  const Result<YuyvImage> decoded = decode_jpeg(*jpeg);
  ASSERT_TRUE(decoded) << decoded.error();
  EXPECT_EQ(decoded->width, 320);
  EXPECT_EQ(decoded->height, 240);
  ASSERT_EQ(decoded->yuyv.size(), picture.size());
  // a border column of chroma is smoothed against its neighbour, so the frame is left out
  for (int y = 1; y < 239; ++y)
    for (int byte = 8; byte < 632; ++byte) {
      const std::size_t at = static_cast<std::size_t>(y) * 640 + static_cast<std::size_t>(byte);
      ASSERT_LE(difference(decoded->yuyv[at], picture[at]), 6) << "row " << y << " byte " << byte;
    }
}

/// A picture of noise, which is the hardest to compress.
std::string noise(int width, int height) {
  std::mt19937 random(1);
  std::string yuyv(static_cast<std::size_t>(width) * static_cast<std::size_t>(height) * 2, '\0');
  for (char& value : yuyv) value = static_cast<char>(random());
  return yuyv;
}

TEST(Jpeg, EncodesNoiseOfAnySizeAtTheHighestQuality) {
  for (const int width : {4, 8, 12, 16, 20, 100, 640})
    for (const int height : {2, 6, 8, 10, 30, 480})
      for (const int quality : {1, 95, 96, 100}) {
        const Result<std::string> jpeg = encode_jpeg(noise(width, height), width, height, {.quality = quality});
        ASSERT_TRUE(jpeg) << jpeg.error();
        EXPECT_LT(jpeg->size(), static_cast<std::size_t>(4 * (width + 15) * (height + 7) + 2048));
        const Result<YuyvImage> decoded = decode_jpeg(*jpeg);
        ASSERT_TRUE(decoded) << decoded.error();
        EXPECT_EQ(decoded->width, width);
        EXPECT_EQ(decoded->height, height);
      }
}

TEST(Jpeg, HalvesAPictureByMeansOfItsPixels) {
  const std::string grey(640 * 480 * 2, '\x80');
  const Result<std::string> jpeg = encode_jpeg(grey, 640, 480, {.width = 320, .quality = 60});
  ASSERT_TRUE(jpeg);
  const Result<YuyvImage> decoded = decode_jpeg(*jpeg);
  ASSERT_TRUE(decoded);
  EXPECT_EQ(decoded->width, 320);
  EXPECT_EQ(decoded->height, 240);
  for (const char value : decoded->yuyv) ASSERT_LE(difference(value, '\x80'), 1);
}

TEST(Jpeg, NamesTheWrongValue) {
  EXPECT_EQ(encode_jpeg(std::string(10, 'x'), 640, 480).error(),
            "JPEG: expected 2 bytes per pixel of a 640x480 image, got 10 bytes");
  EXPECT_EQ(encode_jpeg("", 3, 480).error(),
            "JPEG: expected a width in multiples of 4 and an even height up to 4096 px, got 3x480");
  EXPECT_EQ(encode_jpeg(gradient(8, 8), 8, 8, {.width = 5}).error(), "JPEG: expected the width 8 or half of it, got 5");
  EXPECT_EQ(encode_jpeg(gradient(8, 8), 8, 8, {.quality = 0}).error(), "JPEG: quality must be 1 .. 100, got 0");
}

TEST(Jpeg, SurvivesEveryTruncationAndFlippedByte) {
  const std::string jpeg = *encode_jpeg(gradient(16, 16), 16, 16);
  for (std::size_t size = 0; size < jpeg.size(); ++size) (void)decode_jpeg(jpeg.substr(0, size));
  for (std::size_t at = 0; at < jpeg.size(); ++at) {
    std::string damaged = jpeg;
    damaged[at] = static_cast<char>(damaged[at] ^ 0x5a);
    const Result<YuyvImage> decoded = decode_jpeg(damaged);
    if (decoded)
      EXPECT_EQ(decoded->yuyv.size(),
                static_cast<std::size_t>(decoded->width) * static_cast<std::size_t>(decoded->height) * 2);
    else
      EXPECT_EQ(decoded.error().substr(0, 6), "JPEG: ");
  }
}

}  // namespace
}  // namespace robot::image
