#include "robot/truth/tags/picture_source.h"

#include <string_view>
#include <utility>

#include "robot/core/text.h"
#include "robot/nao/camera/video_device.h"
#include "robot/truth/tags/picture_camera.h"
#include "robot/truth/tags/picture_folder.h"

namespace robot::truth::tags {
namespace {

constexpr std::string_view kCamera = "camera:";
constexpr std::string_view kPictures = "pictures:";

}  // namespace

bool is_picture_address(const std::string& address) {
  return address.starts_with(kCamera) || address.starts_with(kPictures);
}

Result<std::unique_ptr<PictureSource>> open_pictures(const std::string& address, PictureSize size,
                                                     const SessionClock& clock) {
  if (address.starts_with(kPictures)) return PictureFolder::open(address.substr(kPictures.size()), address);
  if (address.starts_with(kCamera) && address.size() > kCamera.size())
    return std::unique_ptr<PictureSource>(std::make_unique<PictureCamera>(
        address.substr(kCamera.size()), size, std::make_unique<nao::KernelVideoDevice>(), clock));
  return Error{
      formatted("source: expected camera:/dev/videoN or pictures:FOLDER, got '%s'", printable(address, 80).c_str())};
}

}  // namespace robot::truth::tags
