#include "robot/core/files.h"

#include <fcntl.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <cstring>

namespace robot {

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

Result<std::vector<std::filesystem::path>> entries_of(const std::filesystem::path& folder) {
  std::vector<std::filesystem::path> entries;
  std::error_code error;
  for (std::filesystem::directory_iterator entry(folder, error), end; !error && entry != end; entry.increment(error))
    entries.push_back(entry->path());
  if (error) return Error{"cannot read the folder " + folder.string() + ": " + error.message()};
  std::ranges::sort(entries);
  return entries;
}

std::filesystem::path absolute_path(const std::filesystem::path& path) {
  std::error_code error;
  const std::filesystem::path whole = std::filesystem::absolute(path, error).lexically_normal();
  if (error) return path;
  return whole.has_filename() ? whole : whole.parent_path();
}

Result<void> replace_file(const std::filesystem::path& path, std::string_view bytes, unsigned mode) {
  std::string beside;
  {
    // threads, processes and other machines may replace the same file: each makes a file of its own
    FileDescriptor file;
    for (int number = 0; !file; ++number) {
      beside = path.string() + ".new" + std::to_string(number);
      file = FileDescriptor(::open(beside.c_str(), O_WRONLY | O_CREAT | O_EXCL | O_CLOEXEC, static_cast<mode_t>(mode)));
      if (!file && errno != EEXIST) return file_error("cannot write", path, errno);
    }
    while (!bytes.empty()) {
      const ssize_t n = ::write(file.get(), bytes.data(), bytes.size());
      if (n < 0 && errno == EINTR) continue;
      if (n < 0) {
        const int reason = errno;
        ::unlink(beside.c_str());
        return file_error("cannot write", path, reason);
      }
      bytes.remove_prefix(static_cast<std::size_t>(n));
    }
  }
  if (::rename(beside.c_str(), path.c_str()) != 0) {
    const int reason = errno;
    ::unlink(beside.c_str());
    return file_error("cannot write", path, reason);
  }
  return {};
}

}  // namespace robot
