// Files of depth recordings for tests, and the bad input that each of their readers must survive.
#pragma once

#include <gtest/gtest.h>

#include <cstdint>
#include <filesystem>
#include <fstream>
#include <string>
#include <string_view>

#include "robot/truth/sensor/image.h"

namespace tests {

/// Returns an image whose values depend on their place, up to `greatest`.
robot::truth::GreyImage grey_image(int width, int height, std::uint16_t greatest = 65535);
robot::truth::ColourImage colour_image(int width, int height);

std::string pgm_of(const robot::truth::GreyImage& image);
std::string fakenect_pgm_of(const robot::truth::GreyImage& image);
std::string ppm_of(const robot::truth::ColourImage& image);
std::string png_of(const robot::truth::GreyImage& image, bool interlaced = false);
std::string png_of(const robot::truth::ColourImage& image);
/// `compression` as libtiff numbers it; `big_endian` is the order of the file's bytes.
std::string tiff_of(const robot::truth::GreyImage& image, int compression, bool big_endian = false);
std::string tiff_in_tiles_of(const robot::truth::GreyImage& image);
std::string pclzf_of(const robot::truth::GreyImage& image);
std::string pclzf_of(const robot::truth::ColourImage& image);
std::string pcl_xml(double focal, double centre_x, double centre_y);

void write_file(const std::filesystem::path& path, std::string_view bytes);

/// Reads each beginning of `bytes` except the whole; none is an image.
template <class Reader>
void expect_no_beginning_is_read(const std::string& bytes, const Reader& reader) {
  for (std::size_t size = 0; size < bytes.size(); ++size) {
    const auto image = reader(std::string_view(bytes).substr(0, size));
    ASSERT_FALSE(image) << size << " bytes of " << bytes.size();
    ASSERT_FALSE(image.error().empty());
    ASSERT_EQ(image.error().find('\n'), std::string::npos);
  }
}

/// Reads `bytes` with each bit flipped. Each is an image or an Error; the sanitizers watch the rest.
template <class Reader>
void survive_each_flip(std::string bytes, const Reader& reader) {
  for (char& byte : bytes)
    for (int bit = 0; bit < 8; ++bit) {
      byte = static_cast<char>(byte ^ (1 << bit));
      const auto image = reader(std::string_view(bytes));
      ASSERT_TRUE(image || !image.error().empty());
      byte = static_cast<char>(byte ^ (1 << bit));
    }
}

}  // namespace tests
