#include "robot/core/byte_source.h"

#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>

namespace robot {
namespace {

Error too_short(const ByteSource& source, std::uint64_t offset, std::uint64_t length) {
  return Error{source.name() + ": expected " + std::to_string(length) + " bytes at byte " + std::to_string(offset) +
               ", the file ends at byte " + std::to_string(source.size())};
}

bool holds(const ByteSource& source, std::uint64_t offset, std::uint64_t length) {
  return offset <= source.size() && length <= source.size() - offset;
}

}  // namespace

Result<std::string> read_bytes(const ByteSource& source, std::uint64_t offset, std::uint64_t length) {
  if (!holds(source, offset, length)) return too_short(source, offset, length);
  std::string bytes;
  // a 32-bit robot's files may be larger than its memory can be
  if (length > bytes.max_size())
    return Error{source.name() + ": expected at most " + std::to_string(bytes.max_size()) + " bytes at once, got " +
                 std::to_string(length)};
  bytes.resize(static_cast<std::size_t>(length));
  if (const Result<void> done = source.read(offset, bytes); !done) return done.failure();
  return bytes;
}

FileSource::FileSource(std::filesystem::path path, FileDescriptor file, std::uint64_t size)
    : path_(std::move(path)), name_(path_.filename().string()), file_(std::move(file)), size_(size) {}

Result<std::shared_ptr<const FileSource>> FileSource::open(const std::filesystem::path& path, Links links) {
  // O_NONBLOCK: opening a pipe would wait for its writer; it has no effect on files
  const int follow = links == Links::refuse ? O_NOFOLLOW : 0;
  FileDescriptor file(::open(path.c_str(), O_RDONLY | O_CLOEXEC | O_NONBLOCK | follow));
  if (!file && errno == ELOOP && links == Links::refuse)
    return Error{"cannot read " + path.string() + ": expected a file, got a symbolic link"};
  if (!file) return file_error("cannot read", path, errno);
  return of(path, std::move(file));
}

Result<std::shared_ptr<const FileSource>> FileSource::of(const std::filesystem::path& path, FileDescriptor file) {
  struct stat status {};
  if (::fstat(file.get(), &status) != 0) return file_error("cannot read", path, errno);
  if (!S_ISREG(status.st_mode)) return Error{"cannot read " + path.string() + ": expected a file"};
  const auto size = static_cast<std::uint64_t>(status.st_size);
  return std::shared_ptr<const FileSource>(new FileSource(path, std::move(file), size));
}

Result<void> FileSource::read(std::uint64_t offset, std::span<char> into) const {
  if (!holds(*this, offset, into.size())) return too_short(*this, offset, into.size());
  while (!into.empty()) {
    const ssize_t n = ::pread(file_.get(), into.data(), into.size(), static_cast<off_t>(offset));
    if (n < 0 && errno == EINTR) continue;
    if (n < 0) return file_error("cannot read", path_, errno);
    if (n == 0) return Error{name_ + ": was cut to " + std::to_string(offset) + " bytes while it was read"};
    into = into.subspan(static_cast<std::size_t>(n));
    offset += static_cast<std::uint64_t>(n);
  }
  return {};
}

Result<void> MemorySource::read(std::uint64_t offset, std::span<char> into) const {
  if (!holds(*this, offset, into.size())) return too_short(*this, offset, into.size());
  std::copy_n(bytes_.data() + offset, into.size(), into.data());
  return {};
}

}  // namespace robot
