// A process without free file descriptors.
#pragma once

#include <fcntl.h>
#include <sys/resource.h>

#include <vector>

#include "robot/core/files.h"

namespace tests {

/// Whether a test may use up all file descriptors. The sanitizer of undefined behaviour cannot check objects without one.
#ifdef TESTS_NEED_DESCRIPTORS
inline constexpr bool kCanUseUpDescriptors = false;
#else
inline constexpr bool kCanUseUpDescriptors = true;
#endif

/// Takes all file descriptors that this process may still open, and gives them back at its end.
class UsedUpDescriptors {
 public:
  UsedUpDescriptors() {
    ::getrlimit(RLIMIT_NOFILE, &before_);
    rlimit few = before_;
    few.rlim_cur = 256;  // so that it is quick
    ::setrlimit(RLIMIT_NOFILE, &few);
    while (robot::FileDescriptor one{::open("/dev/null", O_RDONLY | O_CLOEXEC)}) taken_.push_back(std::move(one));
  }
  ~UsedUpDescriptors() { ::setrlimit(RLIMIT_NOFILE, &before_); }
  UsedUpDescriptors(const UsedUpDescriptors&) = delete;
  UsedUpDescriptors& operator=(const UsedUpDescriptors&) = delete;

 private:
  rlimit before_{};
  std::vector<robot::FileDescriptor> taken_;
};

}  // namespace tests
