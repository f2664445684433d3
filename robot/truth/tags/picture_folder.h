// A folder of pictures as a source.
#pragma once

#include <cstddef>
#include <filesystem>
#include <memory>
#include <string>
#include <vector>

#include "robot/truth/tags/picture_source.h"

namespace robot::truth::tags {

/// The files *.jpg, *.jpeg, *.png and *.ppm of a folder, sorted by time or by name. Symbolic links are left out.
///
/// A name may be the capture time since the epoch: "1712345678.250000.jpg" [s], or a whole number of 13, 16 or 19
/// digits [ms, µs, ns]. If one name is none, the pictures have 30 a second, the first at 1 s after the epoch.
class PictureFolder final : public PictureSource {
 public:
  /// Returns an Error if the folder cannot be read or has no picture.
  static Result<std::unique_ptr<PictureSource>> open(const std::filesystem::path& folder, std::string address);

  Result<std::optional<Picture>> next() override;
  const std::string& address() const override { return address_; }
  bool live() const override { return false; }

 private:
  struct File {
    std::filesystem::path path;
    std::uint64_t capture_ns = 0;
  };

  PictureFolder(std::vector<File> files, std::string address);

  std::vector<File> files_;
  std::string address_;
  std::size_t next_ = 0;
};

/// Returns the capture time [ns since the epoch] that a file's name without its extension is, or nothing.
std::optional<std::uint64_t> time_in_name(std::string_view name);

}  // namespace robot::truth::tags
