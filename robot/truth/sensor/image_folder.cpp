#include <algorithm>
#include <array>
#include <cctype>
#include <cmath>
#include <memory>
#include <string>
#include <vector>

#include "robot/core/clock.h"
#include "robot/core/folder.h"
#include "robot/core/text.h"
#include "robot/truth/sensor/camera_file.h"
#include "robot/truth/sensor/kinect.h"
#include "robot/truth/sensor/name_time.h"
#include "robot/truth/sensor/netpbm.h"
#include "robot/truth/sensor/png.h"
#include "robot/truth/sensor/recording.h"
#include "robot/truth/sensor/tiff.h"

namespace robot::truth {
namespace {

constexpr std::size_t kMaxImages = 2'000'000;  // 18 hours
constexpr double kDefaultRate = 30;            // [1/s]

using GreyReader = Result<GreyImage> (*)(std::string_view);

/// Returns the reader for files of this name, or nullptr.
GreyReader reader_of(const std::filesystem::path& name) {
  std::string extension = name.extension().string();
  std::transform(extension.begin(), extension.end(), extension.begin(),
                 [](unsigned char letter) { return static_cast<char>(std::tolower(letter)); });
  struct Format {
    std::string_view extension;
    GreyReader reader;
  };
  constexpr std::array<Format, 4> formats = {
      {{".png", read_png}, {".pgm", read_pgm}, {".tif", read_tiff}, {".tiff", read_tiff}}};
  for (const Format& format : formats)
    if (format.extension == extension) return format.reader;
  return nullptr;
}

/// The images of a folder and a person's knowledge of their camera.
struct ImageFolder {
  std::filesystem::path path;
  CameraFile camera;
  std::vector<std::string> names;

  std::uint64_t capture_ns(std::size_t number) const {
    if (!camera.capture_ns.empty()) return camera.capture_ns[number];
    if (const auto time = time_in_name(names[number])) return *time;
    const double seconds = static_cast<double>(number) / camera.rate.value_or(kDefaultRate);
    return static_cast<std::uint64_t>(std::llround(seconds * static_cast<double>(kSecond)));
  }

  Result<DepthFrame> read(std::size_t number) const {
    Result<GreyImage> image = read_image(path / names[number], reader_of(names[number]));
    if (!image) return image.failure();
    DepthFrame frame;
    frame.intrinsics = kinect_intrinsics(image->width, image->height);
    frame.depth = std::move(image->values);
    frame.capture_ns = capture_ns(number);
    if (const Result<void> applied = apply(camera, frame); !applied)
      return applied.failure((path / names[number]).string());
    return frame;
  }
};

/// Reads the camera.json of a folder; without one all is as for a Kinect.
Result<CameraFile> read_camera_of(const std::filesystem::path& folder) {
  if (!is_plain_file(folder / "camera.json")) return CameraFile{};
  return read_camera_file(folder / "camera.json");
}

}  // namespace

Result<std::unique_ptr<DepthSource>> open_image_folder(const std::string& address,
                                                       const std::filesystem::path& folder) {
  const Result<std::vector<FolderEntry>> entries = list_folder(folder, kMaxImages);
  if (!entries) return entries.failure();
  const Result<CameraFile> camera = read_camera_of(folder);
  if (!camera) return camera.failure();
  auto images = std::make_shared<ImageFolder>(ImageFolder{folder, *camera, {}});
  for (const FolderEntry& entry : *entries)
    if (entry.kind == FolderEntry::Kind::file && reader_of(entry.name)) images->names.push_back(entry.name);

  if (images->names.empty())
    return Error{folder.string() + ": expected images (*.png, *.pgm, *.tif, *.tiff), got none"};
  if (!camera->capture_ns.empty() && camera->capture_ns.size() != images->names.size())
    return Error{formatted("%s: expected \"capture_ns\" of %zu images, got %zu", (folder / "camera.json").c_str(),
                           images->names.size(), camera->capture_ns.size())};
  return std::unique_ptr<DepthSource>(std::make_unique<Recording>(
      address, images->names.size(), [images](std::size_t number) { return images->read(number); }));
}

}  // namespace robot::truth
