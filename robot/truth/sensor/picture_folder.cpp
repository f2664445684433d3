#include <algorithm>
#include <array>
#include <cstdint>
#include <memory>
#include <string_view>
#include <vector>

#include "robot/core/clock.h"
#include "robot/core/folder.h"
#include "robot/truth/sensor/colour_codec.h"
#include "robot/truth/sensor/name_time.h"
#include "robot/truth/sensor/ordinary_camera.h"
#include "robot/truth/sensor/recording.h"

namespace robot::truth {
namespace {

constexpr std::size_t kMostPictures = 1'000'000;
constexpr std::array<std::string_view, 4> kExtensions{".jpg", ".jpeg", ".png", ".ppm"};

struct PictureFile {
  std::filesystem::path path;
  std::uint64_t capture_ns = 0;
};

bool is_picture(const FolderEntry& entry) {
  const std::string extension = std::filesystem::path(entry.name).extension().string();
  return entry.kind == FolderEntry::Kind::file && std::ranges::find(kExtensions, extension) != kExtensions.end();
}

}  // namespace

Result<std::unique_ptr<DepthSource>> open_picture_folder(const std::string& address,
                                                         const std::filesystem::path& folder) {
  const Result<std::vector<FolderEntry>> entries = list_folder(folder, kMostPictures);
  if (!entries) return entries.failure();
  auto files = std::make_shared<std::vector<PictureFile>>();
  bool all_timed = true;
  for (const FolderEntry& entry : *entries) {
    if (!is_picture(entry)) continue;
    const auto capture_ns = time_in_name(entry.name);
    all_timed = all_timed && capture_ns.has_value();
    files->push_back({folder / entry.name, capture_ns.value_or(0)});
  }
  if (files->empty()) return Error{folder.string() + ": expected pictures (*.jpg, *.jpeg, *.png, *.ppm), got none"};
  if (!all_timed)
    for (std::size_t i = 0; i < files->size(); ++i) (*files)[i].capture_ns = kSecond + i * kSecond / 30;
  std::ranges::sort(*files, {}, &PictureFile::capture_ns);
  return std::unique_ptr<DepthSource>(
      std::make_unique<Recording>(address, files->size(), [files](std::size_t number) -> Result<DepthFrame> {
        const PictureFile& file = (*files)[number];
        Result<ColourImage> image = read_image(file.path, read_colour);
        if (!image) return image.failure();
        return picture_frame(*std::move(image), file.capture_ns);
      }));
}

}  // namespace robot::truth
