#include <memory>
#include <string>
#include <vector>

#include "robot/core/clock.h"
#include "robot/core/folder.h"
#include "robot/core/text.h"
#include "robot/truth/sensor/kinect.h"
#include "robot/truth/sensor/name_time.h"
#include "robot/truth/sensor/pcl_camera.h"
#include "robot/truth/sensor/pclzf.h"
#include "robot/truth/sensor/recording.h"

namespace robot::truth {
namespace {

constexpr std::size_t kMaxPclzfFiles = 6'000'000;  // of 18 hours
constexpr std::string_view kDepthEnd = "_depth.pclzf";

/// Reads the colours of an image of this size.
Result<std::vector<std::uint8_t>> read_colours(const std::filesystem::path& path, const Intrinsics& size) {
  Result<ColourImage> colour = read_image(path, read_pclzf_colour);
  if (!colour) return colour.failure();
  if (colour->width != size.width || colour->height != size.height)
    return Error{path.string() + formatted(": expected %dx%d px as its depth image, got %dx%d", size.width, size.height,
                                           colour->width, colour->height)};
  return std::move(colour->rgb);
}

/// Reads the image NAME whose files begin with `base`, FOLDER/NAME.
Result<DepthFrame> read_pcl_frame(const std::filesystem::path& base) {
  Result<GreyImage> depth = read_image(base.string() + std::string(kDepthEnd), read_pclzf_depth);
  if (!depth) return depth.failure();
  const Result<PclCamera> camera = read_image(base.string() + ".xml", parse_pcl_camera);
  if (!camera) return camera.failure();

  DepthFrame frame;
  frame.intrinsics = kinect_intrinsics(depth->width, depth->height);
  frame.intrinsics.focal_x = camera->focal_x;
  frame.intrinsics.focal_y = camera->focal_y;
  frame.intrinsics.centre_x = camera->centre_x;
  frame.intrinsics.centre_y = camera->centre_y;
  frame.unit = camera->unit;
  frame.depth = std::move(depth->values);

  const std::filesystem::path colours = base.string() + "_rgb.pclzf";
  if (!is_plain_file(colours)) return frame;
  Result<std::vector<std::uint8_t>> rgb = read_colours(colours, frame.intrinsics);
  if (!rgb) return rgb.failure();
  frame.rgb = *std::move(rgb);
  return frame;
}

}  // namespace

Result<std::unique_ptr<DepthSource>> open_pclzf(const std::string& address, const std::filesystem::path& folder) {
  const Result<std::vector<FolderEntry>> entries = list_folder(folder, kMaxPclzfFiles);
  if (!entries) return entries.failure();
  std::vector<std::string> names;
  for (const FolderEntry& entry : *entries)
    if (entry.kind == FolderEntry::Kind::file && entry.name.ends_with(kDepthEnd))
      names.push_back(entry.name.substr(0, entry.name.size() - kDepthEnd.size()));
  if (names.empty()) return Error{folder.string() + ": expected images (*_depth.pclzf), got none"};

  const std::size_t images = names.size();
  return std::unique_ptr<DepthSource>(
      std::make_unique<Recording>(address, images, [folder, names = std::move(names)](std::size_t number) {
        Result<DepthFrame> frame = read_pcl_frame(folder / names[number]);
        // names of other programs may contain no time; then the images have the Kinect's rate
        if (frame) frame->capture_ns = time_in_name(names[number]).value_or(number * kSecond / 30);
        return frame;
      }));
}

}  // namespace robot::truth
