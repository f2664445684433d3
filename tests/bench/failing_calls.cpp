// A library for LD_PRELOAD that lets calls to the system fail, one at a time, in a program that knows nothing of it.
//
//   FORESIGHT_FAULTS=FOLDER   LD_PRELOAD=libfailing_calls.so   PROGRAM …
//
// A call fails that comes from a place in the program that has failed less than FORESIGHT_FAULTS_EACH times (2). A place is the
// function with the chain of its callers, so that each use of the system fails. The next fault comes no sooner than
// FORESIGHT_FAULTS_PAUSE_MS (20) after the last one. Faults begin when the file FOLDER/begin exists and end when it is gone. Each
// fault is one line of
// FOLDER/faults-<process>: its number, the function, the system error and the place.
//
// The file FOLDER/clock, eight bytes of nanoseconds, is added to the system's clock of the program: a clock that steps.
//
// These fail: files and folders, threads, descriptors, and memory blocks of 64 kB and more.
#include <dirent.h>
#include <dlfcn.h>
#include <execinfo.h>
#include <fcntl.h>
#include <pthread.h>
#include <sys/epoll.h>
#include <sys/eventfd.h>
#include <sys/mman.h>
#include <sys/socket.h>
#include <sys/stat.h>
#include <sys/uio.h>
#include <unistd.h>

#include <atomic>
#include <cerrno>
#include <cstdarg>
#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <ctime>

namespace {

constexpr std::size_t kLargeBytes = 64 * 1024;
constexpr int kCallers = 10;              // of a place
constexpr std::size_t kPlaces = 1 << 16;  // a power of two; more than any program has

/// Places that have failed: a hash and how often. A fixed table, because memory is among the things that fail.
struct Place {
  std::atomic<std::uint64_t> hash;
  std::atomic<std::uint32_t> faults;
};
Place places[kPlaces];

std::atomic<std::uint64_t> next_fault_ns = 0;
std::atomic<std::uint64_t> number = 0;
std::atomic<int> log_file = -1;
std::uint32_t each = 2;
std::uint64_t pause_ns = 20'000'000;
char begin_path[512];
std::atomic<std::int64_t> no_offset_ns = 0;
std::atomic<std::int64_t>* clock_offset_ns = &no_offset_ns;
std::atomic<bool> ready = false, begun = false;
thread_local bool inside = false;  // the library's own calls do not fail

template <class Function>
Function real(const char* name) {
  return reinterpret_cast<Function>(dlsym(RTLD_NEXT, name));
}

std::uint64_t now_ns() {
  timespec now{};
  clock_gettime(CLOCK_MONOTONIC, &now);
  return static_cast<std::uint64_t>(now.tv_sec) * 1'000'000'000 + static_cast<std::uint64_t>(now.tv_nsec);
}

struct Inside {
  Inside() { inside = true; }
  ~Inside() { inside = false; }
};

__attribute__((constructor)) void prepare() {
  const Inside guard;
  const char* folder = std::getenv("FORESIGHT_FAULTS");
  if (folder == nullptr) return;
  if (const char* text = std::getenv("FORESIGHT_FAULTS_EACH")) each = static_cast<std::uint32_t>(std::atoi(text));
  if (const char* text = std::getenv("FORESIGHT_FAULTS_PAUSE_MS"))
    pause_ns = static_cast<std::uint64_t>(std::atoi(text)) * 1'000'000;
  char path[512];
  std::snprintf(path, sizeof path, "%s/faults-%d", folder, static_cast<int>(getpid()));
  std::snprintf(begin_path, sizeof begin_path, "%s/begin", folder);
  log_file = open(path, O_WRONLY | O_CREAT | O_APPEND | O_CLOEXEC, 0644);
  std::snprintf(path, sizeof path, "%s/clock", folder);
  const int clock = open(path, O_RDWR | O_CREAT | O_CLOEXEC, 0644);
  if (ftruncate(clock, sizeof(std::int64_t)) == 0)
    clock_offset_ns =
        static_cast<std::atomic<std::int64_t>*>(mmap(nullptr, sizeof(std::int64_t), PROT_READ, MAP_SHARED, clock, 0));
  close(clock);
  void* warm[1];
  backtrace(warm, 1);  // loads its library now
  ready = true;
}

/// Looks for the file FOLDER/begin, every 10 ms.
bool faults_are_on() {
  static std::atomic<std::uint64_t> next_look_ns = 0;
  const std::uint64_t now = now_ns();
  if (now < next_look_ns) return begun;
  next_look_ns = now + 10'000'000;
  return begun = access(begin_path, F_OK) == 0;
}

/// Returns the hash of the chain of callers, the same in every run of the same program.
std::uint64_t place_of(const char* function) {
  void* callers[kCallers + 3];
  const int count = backtrace(callers, kCallers + 3);
  std::uint64_t hash = 1469598103934665603ull;
  const auto add = [&hash](std::uint64_t value) { hash = (hash ^ value) * 1099511628211ull; };
  for (const char* letter = function; *letter != 0; ++letter) add(static_cast<unsigned char>(*letter));
  for (int i = 3; i < count; ++i) {
    Dl_info info{};
    if (dladdr(callers[i], &info) == 0) continue;
    add(reinterpret_cast<std::uintptr_t>(callers[i]) - reinterpret_cast<std::uintptr_t>(info.dli_fbase));
  }
  return hash == 0 ? 1 : hash;
}

/// Counts a fault at the place, or returns false if it has failed often enough.
bool may_fail(std::uint64_t hash) {
  for (std::size_t at = hash % kPlaces, tries = 0; tries < kPlaces; ++tries, at = (at + 1) % kPlaces) {
    std::uint64_t empty = 0;
    Place& place = places[at];
    if (place.hash != hash && !place.hash.compare_exchange_strong(empty, hash) && empty != hash) continue;
    return place.faults.fetch_add(1) < each;
  }
  return false;
}

/// Returns whether this call must fail, and sets errno to `error` then.
bool fails(const char* function, int error) {
  if (inside || !ready.load(std::memory_order_relaxed)) return false;
  const Inside guard;
  const int kept = errno;
  errno = kept;
  if (!faults_are_on()) return errno = kept, false;
  std::uint64_t due = next_fault_ns;
  const std::uint64_t now = now_ns();
  if (now < due) return errno = kept, false;
  const std::uint64_t place = place_of(function);
  if (!may_fail(place) || !next_fault_ns.compare_exchange_strong(due, now + pause_ns)) return errno = kept, false;
  char line[160];
  const int bytes = std::snprintf(line, sizeof line, "%llu %s %d %016llx\n", static_cast<unsigned long long>(++number),
                                  function, error, static_cast<unsigned long long>(place));
  [[maybe_unused]] const ssize_t written = write(log_file, line, static_cast<std::size_t>(bytes));
  errno = error;
  return true;
}

mode_t mode_in(int flags, va_list arguments) {
  return (flags & (O_CREAT | __O_TMPFILE)) != 0 ? static_cast<mode_t>(va_arg(arguments, int)) : 0;
}

bool is_file(int descriptor) {
  struct stat status {};
  return fstat(descriptor, &status) == 0 && S_ISREG(status.st_mode);
}

}  // namespace

// one function of the C library: its failure value, its system error
#define FAILING(result, name, parameters, arguments, failure, error) \
  extern "C" result name parameters {                                \
    if (fails(#name, error)) return failure;                         \
    static const auto real_one = real<result(*) parameters>(#name);  \
    return real_one arguments;                                       \
  }

extern "C" int open(const char* path, int flags, ...) {
  va_list arguments;
  va_start(arguments, flags);
  const mode_t mode = mode_in(flags, arguments);
  va_end(arguments);
  if (fails("open", (flags & O_ACCMODE) == O_RDONLY ? EMFILE : ENOSPC)) return -1;
  static const auto real_one = real<int (*)(const char*, int, ...)>("open");
  return real_one(path, flags, mode);
}

extern "C" int open64(const char* path, int flags, ...) {
  va_list arguments;
  va_start(arguments, flags);
  const mode_t mode = mode_in(flags, arguments);
  va_end(arguments);
  if (fails("open64", (flags & O_ACCMODE) == O_RDONLY ? EMFILE : ENOSPC)) return -1;
  static const auto real_one = real<int (*)(const char*, int, ...)>("open64");
  return real_one(path, flags, mode);
}

extern "C" int openat(int folder, const char* path, int flags, ...) {
  va_list arguments;
  va_start(arguments, flags);
  const mode_t mode = mode_in(flags, arguments);
  va_end(arguments);
  if (fails("openat", EMFILE)) return -1;
  static const auto real_one = real<int (*)(int, const char*, int, ...)>("openat");
  return real_one(folder, path, flags, mode);
}

extern "C" ssize_t write(int descriptor, const void* bytes, size_t size) {
  if (!inside && is_file(descriptor) && fails("write", ENOSPC)) return -1;
  static const auto real_one = real<ssize_t (*)(int, const void*, size_t)>("write");
  return real_one(descriptor, bytes, size);
}

extern "C" ssize_t pwrite(int descriptor, const void* bytes, size_t size, off_t at) {
  if (fails("pwrite", EIO)) return -1;
  static const auto real_one = real<ssize_t (*)(int, const void*, size_t, off_t)>("pwrite");
  return real_one(descriptor, bytes, size, at);
}

extern "C" ssize_t read(int descriptor, void* bytes, size_t size) {
  if (!inside && is_file(descriptor) && fails("read", EIO)) return -1;
  static const auto real_one = real<ssize_t (*)(int, void*, size_t)>("read");
  return real_one(descriptor, bytes, size);
}

FAILING(ssize_t, writev, (int descriptor, const iovec* parts, int count), (descriptor, parts, count), -1, ENOSPC)
FAILING(ssize_t, pread, (int descriptor, void* bytes, size_t size, off_t at), (descriptor, bytes, size, at), -1, EIO)
FAILING(int, fsync, (int descriptor), (descriptor), -1, EIO)
FAILING(int, fdatasync, (int descriptor), (descriptor), -1, EIO)
FAILING(int, ftruncate, (int descriptor, off_t size), (descriptor, size), -1, EIO)
FAILING(int, rename, (const char* from, const char* to), (from, to), -1, ENOSPC)
FAILING(int, mkdir, (const char* path, mode_t mode), (path, mode), -1, ENOSPC)
FAILING(int, unlink, (const char* path), (path), -1, EACCES)
FAILING(int, unlinkat, (int folder, const char* path, int flags), (folder, path, flags), -1, EACCES)
FAILING(DIR*, opendir, (const char* path), (path), nullptr, EMFILE)
FAILING(DIR*, fdopendir, (int descriptor), (descriptor), nullptr, ENOMEM)
FAILING(int, socket, (int domain, int type, int protocol), (domain, type, protocol), -1, EMFILE)
FAILING(int, accept, (int descriptor, sockaddr* address, socklen_t* size), (descriptor, address, size), -1, EMFILE)
FAILING(int, accept4, (int descriptor, sockaddr* address, socklen_t* size, int flags),
        (descriptor, address, size, flags), -1, EMFILE)
FAILING(int, eventfd, (unsigned count, int flags), (count, flags), -1, EMFILE)
FAILING(int, epoll_create1, (int flags), (flags), -1, EMFILE)

extern "C" int pthread_create(pthread_t* thread, const pthread_attr_t* attributes, void* (*run)(void*),
                              void* argument) {
  if (fails("pthread_create", EAGAIN)) return EAGAIN;
  static const auto real_one =
      real<int (*)(pthread_t*, const pthread_attr_t*, void* (*)(void*), void*)>("pthread_create");
  return real_one(thread, attributes, run, argument);
}

extern "C" int clock_gettime(clockid_t clock, timespec* time) {
  static const auto real_one = real<int (*)(clockid_t, timespec*)>("clock_gettime");
  const int failed = real_one(clock, time);
  if (failed != 0 || clock != CLOCK_REALTIME) return failed;
  constexpr std::int64_t kSecond = 1'000'000'000;
  const std::int64_t shifted = time->tv_sec * kSecond + time->tv_nsec + *clock_offset_ns;
  time->tv_sec = shifted / kSecond;
  time->tv_nsec = shifted % kSecond;
  return 0;
}

// large blocks; the C library's own names, because dlsym() itself allocates
extern "C" void* __libc_malloc(size_t size);
extern "C" void* __libc_realloc(void* block, size_t size);
extern "C" void* __libc_calloc(size_t count, size_t size);

extern "C" void* malloc(size_t size) {
  if (size >= kLargeBytes && fails("malloc", ENOMEM)) return nullptr;
  return __libc_malloc(size);
}
extern "C" void* realloc(void* block, size_t size) {
  if (size >= kLargeBytes && fails("realloc", ENOMEM)) return nullptr;
  return __libc_realloc(block, size);
}
extern "C" void* calloc(size_t count, size_t size) {
  if (count * size >= kLargeBytes && fails("calloc", ENOMEM)) return nullptr;
  return __libc_calloc(count, size);
}
