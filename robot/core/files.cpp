#include "robot/core/files.h"

#include <fcntl.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <cstring>

namespace robot {
namespace {

/// A new file beside the one at `path`.
struct Beside {
  std::string path;
  FileDescriptor file;
};

/// Threads, processes and other machines may replace the same file: each makes a file of its own.
Result<Beside> make_beside(const std::filesystem::path& path, unsigned mode) {
  for (int number = 0;; ++number) {
    std::string name = path.string() + ".new" + std::to_string(number);
    FileDescriptor file(::open(name.c_str(), O_WRONLY | O_CREAT | O_EXCL | O_CLOEXEC, static_cast<mode_t>(mode)));
    if (file) return Beside{std::move(name), std::move(file)};
    if (errno != EEXIST) return file_error("cannot write", path, errno);
  }
}

/// Returns false after a failure; `errno` gives the reason.
bool write_all(int file, std::string_view bytes) {
  while (!bytes.empty()) {
    const ssize_t n = ::write(file, bytes.data(), bytes.size());
    if (n < 0 && errno == EINTR) continue;
    if (n < 0) return false;
    bytes.remove_prefix(static_cast<std::size_t>(n));
  }
  return true;
}

Result<void> replace(const std::filesystem::path& path, std::string_view bytes, unsigned mode, bool stored) {
  Result<Beside> beside = make_beside(path, mode);
  if (!beside) return beside.failure();
  const int file = beside->file.get();
  const bool written = write_all(file, bytes) && (!stored || ::fsync(file) == 0);
  if (written && ::rename(beside->path.c_str(), path.c_str()) == 0) return {};
  const int reason = errno;
  ::unlink(beside->path.c_str());
  return file_error("cannot write", path, reason);
}

}  // namespace

Error file_error(std::string_view what, const std::filesystem::path& path, int error_number) {
  return Error{std::string(what) + " " + path.string() + ": " + std::strerror(error_number)};
}

FileDescriptor& FileDescriptor::operator=(FileDescriptor&& other) noexcept {
  if (this != &other) {
    reset();
    number_ = std::exchange(other.number_, -1);
  }
  return *this;
}

void FileDescriptor::reset() {
  if (number_ >= 0) ::close(number_);
  number_ = -1;
}

FileDescriptor spare_descriptor() { return FileDescriptor(::open("/dev/null", O_RDONLY | O_CLOEXEC)); }

bool is_out_of_descriptors(int error_number) { return error_number == EMFILE || error_number == ENFILE; }

Result<std::string> read_file(const std::filesystem::path& path, std::size_t max_bytes) {
  const FileDescriptor file(::open(path.c_str(), O_RDONLY | O_CLOEXEC));
  if (!file) return file_error("cannot read", path, errno);

  std::string bytes;
  char block[65536];
  while (true) {
    const ssize_t n = ::read(file.get(), block, sizeof block);
    if (n < 0 && errno == EINTR) continue;
    if (n < 0) return file_error("cannot read", path, errno);
    if (n == 0) return bytes;
    if (bytes.size() + static_cast<std::size_t>(n) > max_bytes)
      return Error{"cannot read " + path.string() + ": expected at most " + std::to_string(max_bytes) +
                   " bytes, got more"};
    bytes.append(block, static_cast<std::size_t>(n));
  }
}

std::filesystem::path absolute_path(const std::filesystem::path& path) {
  std::error_code error;
  const std::filesystem::path whole = std::filesystem::absolute(path, error).lexically_normal();
  if (error) return path;
  return whole.has_filename() ? whole : whole.parent_path();
}

Result<void> replace_file(const std::filesystem::path& path, std::string_view bytes, unsigned mode) {
  return replace(path, bytes, mode, false);
}

Result<void> store_file(const std::filesystem::path& path, std::string_view bytes, unsigned mode) {
  if (Result<void> replaced = replace(path, bytes, mode, true); !replaced) return replaced;
  const std::filesystem::path parent = path.parent_path();
  const FileDescriptor folder(::open(parent.empty() ? "." : parent.c_str(), O_RDONLY | O_DIRECTORY | O_CLOEXEC));
  // some file systems cannot store a folder by itself: EINVAL
  if (!folder || (::fsync(folder.get()) != 0 && errno != EINVAL)) return file_error("cannot write", path, errno);
  return {};
}

}  // namespace robot
