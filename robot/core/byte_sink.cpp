#include "robot/core/byte_sink.h"

#include <fcntl.h>
#include <sys/uio.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <utility>

namespace robot {
namespace {

/// Returns `pieces` without the first `n` bytes.
std::span<iovec> behind(std::span<iovec> pieces, std::size_t n) {
  while (!pieces.empty() && n >= pieces.front().iov_len) {
    n -= pieces.front().iov_len;
    pieces = pieces.subspan(1);
  }
  if (n > 0) {
    pieces.front().iov_base = static_cast<char*>(pieces.front().iov_base) + n;
    pieces.front().iov_len -= n;
  }
  return pieces;
}

}  // namespace

FileSink::FileSink(std::filesystem::path path, FileDescriptor file) : path_(std::move(path)), file_(std::move(file)) {}

Result<std::unique_ptr<FileSink>> FileSink::create(const std::filesystem::path& path) {
  FileDescriptor file(::open(path.c_str(), O_WRONLY | O_CREAT | O_EXCL | O_APPEND | O_CLOEXEC, 0644));
  if (!file) return file_error("cannot make", path, errno);
  return of(path, std::move(file));
}

std::unique_ptr<FileSink> FileSink::of(const std::filesystem::path& path, FileDescriptor file) {
  return std::unique_ptr<FileSink>(new FileSink(path, std::move(file)));
}

Result<void> FileSink::append(std::span<const std::string_view> pieces) {
  std::array<iovec, 16> vectors;
  while (!pieces.empty()) {
    const std::size_t count = std::min(pieces.size(), vectors.size());
    for (std::size_t i = 0; i < count; ++i) vectors[i] = {const_cast<char*>(pieces[i].data()), pieces[i].size()};
    pieces = pieces.subspan(count);

    // after a short write, the next one returns the reason
    std::span<iovec> left = behind(std::span(vectors).first(count), 0);
    while (!left.empty()) {
      const ssize_t n = ::writev(file_.get(), left.data(), static_cast<int>(left.size()));
      if (n < 0 && errno == EINTR) continue;
      if (n < 0) return file_error("cannot write", path_, errno);
      left = behind(left, static_cast<std::size_t>(n));
    }
  }
  return {};
}

Result<void> FileSink::truncate(std::uint64_t size) {
  if (::ftruncate(file_.get(), static_cast<off_t>(size)) != 0) return file_error("cannot cut", path_, errno);
  return {};
}

}  // namespace robot
