#include "tests/support/jpeg_pictures.h"

#include <turbojpeg.h>

#include "robot/truth/sensor/colour_codec.h"

namespace tests {

using robot::truth::ColourImage;
using robot::truth::DepthFrame;

std::string jpeg_of(const ColourImage& picture, int quality) {
  tjhandle encoder = tjInitCompress();
  unsigned char* bytes = nullptr;
  unsigned long size = 0;
  tjCompress2(encoder, picture.rgb.data(), picture.width, 0, picture.height, TJPF_RGB, &bytes, &size, TJSAMP_422,
              quality, 0);
  std::string jpeg(reinterpret_cast<const char*>(bytes), size);
  tjFree(bytes);
  tjDestroy(encoder);
  return jpeg;
}

DepthFrame as_jpeg(const DepthFrame& picture, int quality) {
  DepthFrame compressed = picture;
  const ColourImage image{picture.intrinsics.width, picture.intrinsics.height, picture.rgb};
  compressed.rgb = robot::truth::read_colour(jpeg_of(image, quality))->rgb;
  return compressed;
}

}  // namespace tests
