#include "tests/support/failing_files.h"

#include <dlfcn.h>
#include <fcntl.h>
#include <sys/stat.h>
#include <sys/types.h>
#include <sys/uio.h>

#include <atomic>
#include <cerrno>
#include <cstdarg>
#include <cstdio>

namespace tests {
namespace {

std::atomic<FileCall> failing = FileCall::create;
std::atomic<int> until = 0, left = 0, failed = 0;
std::atomic<bool> still = false;
std::atomic<int> waiting = 0;

#ifndef TESTS_WITH_SANITIZER
void wait_for_disk() {
  if (!still) return;
  ++waiting;
  still.wait(true);
  --waiting;
}

bool fails(FileCall call) {
  if (call != failing || left <= 0 || until-- > 0 || left-- <= 0) return false;
  ++failed;
  errno = ENOSPC;
  return true;
}

bool is_file(int descriptor) {
  struct stat status {};
  return ::fstat(descriptor, &status) == 0 && S_ISREG(status.st_mode);
}

template <class Function>
Function real(const char* name) {
  return reinterpret_cast<Function>(dlsym(RTLD_NEXT, name));
}
#endif

}  // namespace

void fail_files(FileCall call, int before, int count) {
  mend_files();
  failing = call;
  until = before;
  failed = 0;
  left = count;
}

void stop_files() { still = true; }
int waiting_files() { return waiting; }

void mend_files() {
  left = 0;
  still = false;
  still.notify_all();
}

int failed_files() { return failed; }

}  // namespace tests

#ifndef TESTS_WITH_SANITIZER
// these stand before the functions of the C library
using tests::FileCall;

extern "C" int open(const char* path, int flags, ...) {
  va_list arguments;
  va_start(arguments, flags);
  const mode_t mode = (flags & O_CREAT) != 0 ? va_arg(arguments, mode_t) : 0;
  va_end(arguments);
  tests::wait_for_disk();
  if ((flags & O_CREAT) != 0 && tests::fails(FileCall::create)) return -1;
  static const auto call = tests::real<int (*)(const char*, int, ...)>("open");
  return call(path, flags, mode);
}

extern "C" ssize_t writev(int descriptor, const iovec* parts, int count) {
  tests::wait_for_disk();
  static const auto call = tests::real<ssize_t (*)(int, const iovec*, int)>("writev");
  if (!tests::fails(FileCall::append) && !tests::fails(FileCall::cut)) return call(descriptor, parts, count);
  // a full disk takes the first bytes
  const iovec begin{parts[0].iov_base, parts[0].iov_len / 2};
  (void)call(descriptor, &begin, 1);
  errno = ENOSPC;
  return -1;
}

extern "C" ssize_t write(int descriptor, const void* bytes, size_t size) {
  const bool is_file = tests::is_file(descriptor);
  if (is_file) tests::wait_for_disk();
  if (is_file && tests::fails(FileCall::write)) return -1;
  static const auto call = tests::real<ssize_t (*)(int, const void*, size_t)>("write");
  return call(descriptor, bytes, size);
}

extern "C" int ftruncate(int descriptor, off_t size) noexcept {
  tests::wait_for_disk();
  if (tests::fails(FileCall::cut)) return -1;
  static const auto call = tests::real<int (*)(int, off_t)>("ftruncate");
  return call(descriptor, size);
}

extern "C" int fsync(int descriptor) {
  tests::wait_for_disk();
  if (tests::fails(FileCall::store)) return -1;
  static const auto call = tests::real<int (*)(int)>("fsync");
  return call(descriptor);
}

extern "C" int rename(const char* from, const char* to) noexcept {
  tests::wait_for_disk();
  if (tests::fails(FileCall::rename)) return -1;
  static const auto call = tests::real<int (*)(const char*, const char*)>("rename");
  return call(from, to);
}
#endif
