// Recordings: images in files, read one after the other.
#pragma once

#include <cstddef>
#include <filesystem>
#include <functional>
#include <memory>
#include <string>

#include "robot/core/result.h"
#include "robot/truth/frame/depth_source.h"

namespace robot::truth {

/// A source whose images are files that exist already.
class Recording final : public DepthSource {
 public:
  /// Reads the image with this number, from 0 on.
  using Read = std::function<Result<DepthFrame>(std::size_t)>;

  Recording(std::string address, std::size_t images, Read read)
      : address_(std::move(address)), images_(images), read_(std::move(read)) {}

  Result<std::optional<DepthFrame>> next() override;
  const std::string& address() const override { return address_; }
  bool live() const override { return false; }

 private:
  std::string address_;
  std::size_t images_, at_ = 0;
  Read read_;
};

/// Opens a folder that fakenect-record wrote: INDEX.txt, d-TIME-TICKS.pgm, r-TIME-TICKS.ppm. An image takes the colours of
/// the colour image that is nearest in time, at most 50 ms away.
Result<std::unique_ptr<DepthSource>> open_fakenect(const std::string& address, const std::filesystem::path& folder);

/// Opens a folder of 16-bit images (*.png, *.pgm, *.tif, *.tiff), read in the order of their names; see open_source.h.
Result<std::unique_ptr<DepthSource>> open_image_folder(const std::string& address, const std::filesystem::path& folder);

/// Opens a folder of PCL: NAME_depth.pclzf with NAME.xml, and NAME_rgb.pclzf where it exists.
Result<std::unique_ptr<DepthSource>> open_pclzf(const std::string& address, const std::filesystem::path& folder);

/// Opens a folder of pictures of an ordinary camera (*.jpg, *.jpeg, *.png, *.ppm), by the times in their names. If one name
/// has none (name_time.h), they are read in the order of the names: 30 a second, the first at 1 s after the epoch.
Result<std::unique_ptr<DepthSource>> open_picture_folder(const std::string& address,
                                                         const std::filesystem::path& folder);

/// Reads the file at `path` by one of the readers of image files. An Error names the file.
template <class Image>
Result<Image> read_image(const std::filesystem::path& path, Result<Image> (*reader)(std::string_view));

}  // namespace robot::truth
