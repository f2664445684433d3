#include "tests/support/jpeg_pictures.h"

#include <turbojpeg.h>

#include "robot/truth/tags/picture_codec.h"

namespace tests {

using robot::truth::tags::Picture;

std::string jpeg_of(const Picture& picture, int quality) {
  tjhandle encoder = tjInitCompress();
  unsigned char* bytes = nullptr;
  unsigned long size = 0;
  tjCompress2(encoder, picture.rgb.data(), picture.size.width, 0, picture.size.height, TJPF_RGB, &bytes, &size,
              TJSAMP_422, quality, 0);
  std::string jpeg(reinterpret_cast<const char*>(bytes), size);
  tjFree(bytes);
  tjDestroy(encoder);
  return jpeg;
}

Picture as_jpeg(const Picture& picture, int quality) {
  return *robot::truth::tags::decode_picture(jpeg_of(picture, quality));
}

}  // namespace tests
