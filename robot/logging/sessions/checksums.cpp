#include "robot/logging/sessions/checksums.h"

#include <sys/stat.h>

#include <algorithm>
#include <mutex>
#include <utility>

#include "robot/core/byte_source.h"
#include "robot/core/clock.h"
#include "robot/core/folder.h"
#include "robot/logging/mcap/format.h"

namespace robot::logging {
namespace {

constexpr std::size_t kPieceBytes = 1 << 18;
constexpr std::size_t kMostKept = 100'000;  // about 10 MB

}  // namespace

/// Returns nothing if `path` is no ordinary file.
std::optional<Checksums::Identity> Checksums::identity_of(const std::filesystem::path& path) {
  struct stat status {};
  if (::lstat(path.c_str(), &status) != 0 || !S_ISREG(status.st_mode)) return std::nullopt;
  return Identity(
      status.st_dev, status.st_ino, static_cast<std::uint64_t>(status.st_size),
      static_cast<std::uint64_t>(status.st_mtim.tv_sec) * kSecond + static_cast<std::uint64_t>(status.st_mtim.tv_nsec));
}

Result<std::vector<SessionFile>> Checksums::of_folder(const std::filesystem::path& folder,
                                                      const std::function<bool()>& cancelled) {
  const auto entries = list_folder(folder);
  if (!entries) return entries.failure("session");
  std::vector<SessionFile> files;
  for (const FolderEntry& entry : *entries) {
    const std::filesystem::path path = folder / entry.name;
    const std::optional<Identity> identity = identity_of(path);
    if (!identity || entry.name.starts_with('.')) continue;
    std::optional<std::uint32_t> crc32 = kept(*identity);
    if (!crc32) {
      const Result<std::uint32_t> computed = read(path, cancelled);
      if (!computed) return computed.failure();
      crc32 = *computed;
      // a file that changed meanwhile is read again next time
      if (identity_of(path) == identity) keep(*identity, *crc32);
    }
    files.push_back({.name = entry.name, .size_bytes = std::get<2>(*identity), .crc32 = *crc32});
  }
  return files;
}

Result<std::uint32_t> Checksums::read(const std::filesystem::path& path, const std::function<bool()>& cancelled) {
  const auto source = FileSource::open(path, Links::refuse);
  if (!source) return source.failure();
  std::uint32_t crc32 = 0;
  std::string piece;
  for (std::uint64_t at = 0; at < (*source)->size(); at += piece.size()) {
    if (cancelled && cancelled()) return Error{"the checksum of " + path.string() + " is not wanted any more"};
    piece.resize(static_cast<std::size_t>(std::min<std::uint64_t>(kPieceBytes, (*source)->size() - at)));
    if (const Result<void> done = (*source)->read(at, piece); !done) return done.failure();
    crc32 = mcap::crc32(piece, crc32);
    const std::lock_guard guard(lock_);
    bytes_read_ += piece.size();
  }
  return crc32;
}

std::uint64_t Checksums::bytes_read() const {
  const std::lock_guard guard(lock_);
  return bytes_read_;
}

std::optional<std::uint32_t> Checksums::kept(const Identity& identity) const {
  const std::lock_guard guard(lock_);
  const auto found = kept_.find(identity);
  return found == kept_.end() ? std::nullopt : std::optional(found->second);
}

void Checksums::keep(const Identity& identity, std::uint32_t crc32) {
  const std::lock_guard guard(lock_);
  if (kept_.size() >= kMostKept) kept_.clear();
  kept_[identity] = crc32;
}

}  // namespace robot::logging
