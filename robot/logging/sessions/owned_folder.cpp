#include "robot/logging/sessions/owned_folder.h"

#include <fcntl.h>
#include <sys/file.h>
#include <sys/stat.h>
#include <unistd.h>

#include <cerrno>
#include <system_error>
#include <utility>

namespace robot::logging {
namespace {

constexpr int kMostNames = 1000;

/// Makes the folder of a new session, under a name that no other has. Returns its path.
Result<std::filesystem::path> make_new(const std::filesystem::path& parent, const std::string& name) {
  std::error_code failed;
  std::filesystem::create_directories(parent, failed);
  // an existing folder gives no error; one that cannot be used is named below
  for (int number = 1; number <= kMostNames; ++number) {
    const std::filesystem::path path = parent / (number == 1 ? name : name + "_" + std::to_string(number));
    if (::mkdir(path.c_str(), 0755) == 0) return path;
    if (errno != EEXIST) return file_error("cannot make the folder", path, errno);
  }
  return Error{"cannot make the folder " + (parent / name).string() + ": " + std::to_string(kMostNames) +
               " folders have this name already"};
}

}  // namespace

Result<OwnedFolder> OwnedFolder::make(const std::filesystem::path& parent, const std::string& name) {
  const Result<std::filesystem::path> path = make_new(parent, name);
  if (!path) return path.failure();
  Result<OwnedFolder> folder = own(*path);
  if (!folder) ::rmdir(path->c_str());
  return folder;
}

Result<OwnedFolder> OwnedFolder::own(const std::filesystem::path& path) {
  FileDescriptor folder(::open(path.c_str(), O_RDONLY | O_DIRECTORY | O_CLOEXEC));
  if (!folder) return file_error("cannot read", path, errno);
  FileDescriptor lock(::openat(folder.get(), kLockFile, O_RDWR | O_CREAT | O_NOFOLLOW | O_NONBLOCK | O_CLOEXEC, 0644));
  if (!lock) return file_error("cannot write", path / kLockFile, errno);
  if (::flock(lock.get(), LOCK_EX | LOCK_NB) != 0) {
    if (errno == EWOULDBLOCK) return Error{path.string() + ": it is being recorded already"};
    return file_error("cannot lock", path / kLockFile, errno);
  }
  return OwnedFolder(path, std::move(folder), std::move(lock));
}

OwnedFolder::~OwnedFolder() { release(); }

void OwnedFolder::release() {
  // removed first: afterwards the file may be another owner's
  if (lock_) ::unlinkat(folder_.get(), kLockFile, 0);
  lock_.reset();
}

bool OwnedFolder::is_at(const std::filesystem::path& path) const {
  struct stat ours {
  }, there{};
  return ::fstat(folder_.get(), &ours) == 0 && ::lstat(path.c_str(), &there) == 0 && ours.st_dev == there.st_dev &&
         ours.st_ino == there.st_ino;
}

std::filesystem::path OwnedFolder::present_path() const {
  if (in_place()) return path_;
  std::error_code failed;
  const std::filesystem::path moved =
      std::filesystem::read_symlink("/proc/self/fd/" + std::to_string(folder_.get()), failed);
  return !failed && is_at(moved) ? moved : std::filesystem::path();
}

std::uint64_t OwnedFolder::identity_of(const std::string& name) const {
  struct stat status {};
  return ::fstatat(folder_.get(), name.c_str(), &status, AT_SYMLINK_NOFOLLOW) == 0 ? status.st_ino : 0;
}

void OwnedFolder::discard() {
  release();
  if (in_place()) ::rmdir(path_.c_str());
}

bool is_owned(const std::filesystem::path& path) {
  const FileDescriptor lock(::open((path / kLockFile).c_str(), O_RDONLY | O_NOFOLLOW | O_NONBLOCK | O_CLOEXEC));
  // a lock file that cannot be opened may belong to another user's process
  if (!lock) return errno == EACCES || errno == EPERM || errno == EMFILE || errno == ENFILE;
  return ::flock(lock.get(), LOCK_SH | LOCK_NB) != 0 && errno == EWOULDBLOCK;
}

}  // namespace robot::logging
