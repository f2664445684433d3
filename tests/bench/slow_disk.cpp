#include "tests/bench/slow_disk.h"

#include <sys/stat.h>
#include <sys/syscall.h>
#include <sys/uio.h>
#include <unistd.h>

#include <algorithm>
#include <atomic>
#include <ctime>
#include <mutex>

#include "robot/core/clock.h"
#include "robot/core/lock.h"

namespace bench {
namespace {

SlowDisk disk;
std::atomic<bool> in_use = false;
robot::Mutex lock;
std::uint64_t free_at_ns = 0;  // time when all data written so far are on the disk

/// One write after the other, as on one disk; a stall delays all.
void wait_for(std::uint64_t bytes) {
  std::uint64_t until_ns = 0;
  {
    const std::lock_guard guard(lock);
    std::uint64_t begin_ns = std::max(free_at_ns, robot::monotonic_ns());
    if (disk.stall_every_ns > 0 && begin_ns % disk.stall_every_ns < disk.stall_ns)
      begin_ns += disk.stall_ns - begin_ns % disk.stall_every_ns;
    if (disk.bytes_per_second > 0)
      begin_ns += static_cast<std::uint64_t>(1e9 * static_cast<double>(bytes) / disk.bytes_per_second);
    until_ns = free_at_ns = begin_ns;
  }
  const timespec until{.tv_sec = static_cast<time_t>(until_ns / robot::kSecond),
                       .tv_nsec = static_cast<long>(until_ns % robot::kSecond)};
  while (clock_nanosleep(CLOCK_MONOTONIC, TIMER_ABSTIME, &until, nullptr) != 0) {
  }
}

}  // namespace

void use_slow_disk(const SlowDisk& wanted) {
  disk = wanted;
  in_use = true;
}

}  // namespace bench

// replaces the function of the C library
extern "C" ssize_t writev(int file, const iovec* pieces, int count) {
  struct stat about {};
  if (bench::in_use && fstat(file, &about) == 0 && S_ISREG(about.st_mode)) {
    std::uint64_t bytes = 0;
    for (int i = 0; i < count; ++i) bytes += pieces[i].iov_len;
    bench::wait_for(bytes);
  }
  return syscall(SYS_writev, file, pieces, count);
}
