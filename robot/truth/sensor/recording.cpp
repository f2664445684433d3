#include "robot/truth/sensor/recording.h"

#include "robot/core/files.h"
#include "robot/truth/sensor/image.h"
#include "robot/truth/sensor/pcl_camera.h"

namespace robot::truth {

Result<std::optional<DepthFrame>> Recording::next() {
  if (at_ == images_) return std::optional<DepthFrame>();
  Result<DepthFrame> frame = read_(at_++);
  if (!frame) return frame.failure();
  return std::optional(*std::move(frame));
}

template <class Image>
Result<Image> read_image(const std::filesystem::path& path, Result<Image> (*reader)(std::string_view)) {
  const Result<std::string> bytes = read_file(path, kMaxImageBytes);
  if (!bytes) return bytes.failure();
  Result<Image> image = reader(*bytes);
  if (!image) return image.failure(path.string());
  return image;
}

template Result<GreyImage> read_image(const std::filesystem::path&, Result<GreyImage> (*)(std::string_view));
template Result<ColourImage> read_image(const std::filesystem::path&, Result<ColourImage> (*)(std::string_view));
template Result<PclCamera> read_image(const std::filesystem::path&, Result<PclCamera> (*)(std::string_view));

}  // namespace robot::truth
