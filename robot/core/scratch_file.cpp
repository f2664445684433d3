#include "robot/core/scratch_file.h"

#include <fcntl.h>
#include <unistd.h>

#include <atomic>
#include <cerrno>
#include <string>
#include <utility>

namespace robot {

Result<ScratchFile> ScratchFile::make(const std::filesystem::path& folder) {
  static std::atomic<unsigned> made = 0;
  const std::filesystem::path path = folder / (".scratch." + std::to_string(::getpid()) + "." + std::to_string(++made));
  // not O_TMPFILE, which some file systems do not have
  FileDescriptor file(::open(path.c_str(), O_RDWR | O_CREAT | O_EXCL | O_APPEND | O_CLOEXEC, 0600));
  if (!file) return file_error("cannot make", path, errno);
  if (::unlink(path.c_str()) != 0) return file_error("cannot remove the name of", path, errno);
  return ScratchFile(path, std::move(file));
}

Result<std::unique_ptr<ByteSink>> ScratchFile::sink() const {
  FileDescriptor file(::fcntl(file_.get(), F_DUPFD_CLOEXEC, 0));
  if (!file) return file_error("cannot write", path_, errno);
  return std::unique_ptr<ByteSink>(FileSink::of(path_, std::move(file)));
}

Result<std::shared_ptr<const ByteSource>> ScratchFile::source() const {
  FileDescriptor file(::fcntl(file_.get(), F_DUPFD_CLOEXEC, 0));
  if (!file) return file_error("cannot read", path_, errno);
  auto source = FileSource::of(path_, std::move(file));
  if (!source) return source.failure();
  return std::shared_ptr<const ByteSource>(std::move(*source));
}

}  // namespace robot
