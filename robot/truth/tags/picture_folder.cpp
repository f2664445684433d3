#include "robot/truth/tags/picture_folder.h"

#include <algorithm>
#include <array>
#include <charconv>
#include <string_view>
#include <utility>

#include "robot/core/files.h"
#include "robot/core/folder.h"
#include "robot/core/text.h"
#include "robot/truth/tags/picture_codec.h"

namespace robot::truth::tags {
namespace {

constexpr std::size_t kMostFileBytes = 64u << 20;
constexpr std::size_t kMostFiles = 1'000'000;
constexpr std::array<std::string_view, 4> kExtensions{".jpg", ".jpeg", ".png", ".ppm"};

bool is_picture(const FolderEntry& entry) {
  const std::string extension = std::filesystem::path(entry.name).extension().string();
  return entry.kind == FolderEntry::Kind::file &&
         std::find(kExtensions.begin(), kExtensions.end(), extension) != kExtensions.end();
}

std::optional<std::uint64_t> number_of(std::string_view digits) {
  std::uint64_t number = 0;
  const auto [end, error] = std::from_chars(digits.data(), digits.data() + digits.size(), number);
  if (error != std::errc() || end != digits.data() + digits.size()) return std::nullopt;
  return number;
}

/// Returns `number` with `zeros` zeros behind it.
std::uint64_t shifted(std::uint64_t number, std::size_t zeros) {
  for (; zeros > 0; --zeros) number *= 10;
  return number;
}

}  // namespace

std::optional<std::uint64_t> time_in_name(std::string_view name) {
  const std::size_t point = name.find('.');
  if (point == std::string_view::npos) {
    if (name.size() != 13 && name.size() != 16 && name.size() != 19) return std::nullopt;
    const auto number = number_of(name);
    return number ? std::optional(shifted(*number, 19 - name.size())) : std::nullopt;
  }
  const std::string_view fraction = name.substr(point + 1);
  if (point > 10 || fraction.size() > 9) return std::nullopt;
  const auto seconds = number_of(name.substr(0, point)), parts = number_of(fraction);
  if (!seconds || !parts) return std::nullopt;
  return *seconds * kSecond + shifted(*parts, 9 - fraction.size());
}

Result<std::unique_ptr<PictureSource>> PictureFolder::open(const std::filesystem::path& folder, std::string address) {
  const Result<std::vector<FolderEntry>> entries = list_folder(folder, kMostFiles);
  if (!entries) return entries.failure();
  std::vector<File> files;
  bool all_timed = true;
  for (const FolderEntry& entry : *entries) {
    if (!is_picture(entry)) continue;
    const std::filesystem::path path = folder / entry.name;
    const auto capture_ns = time_in_name(path.stem().string());
    all_timed = all_timed && capture_ns.has_value();
    files.push_back({path, capture_ns.value_or(0)});
  }
  if (files.empty())
    return Error{formatted("folder %s: expected pictures *.jpg, *.jpeg, *.png or *.ppm, got none", folder.c_str())};
  if (!all_timed)
    for (std::size_t i = 0; i < files.size(); ++i) files[i].capture_ns = kSecond + i * kSecond / 30;
  std::sort(files.begin(), files.end(), [](const File& a, const File& b) { return a.capture_ns < b.capture_ns; });
  return std::unique_ptr<PictureSource>(new PictureFolder(std::move(files), std::move(address)));
}

PictureFolder::PictureFolder(std::vector<File> files, std::string address)
    : files_(std::move(files)), address_(std::move(address)) {}

Result<std::optional<Picture>> PictureFolder::next() {
  if (next_ == files_.size()) return std::optional<Picture>();
  const File& file = files_[next_++];
  const Result<std::string> bytes = read_file(file.path, kMostFileBytes);
  if (!bytes) return bytes.failure();
  Result<Picture> picture = decode_picture(*bytes);
  if (!picture) return picture.failure(file.path.string());
  picture->capture_ns = file.capture_ns;
  return std::optional<Picture>(*std::move(picture));
}

}  // namespace robot::truth::tags
