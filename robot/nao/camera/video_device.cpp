#include "robot/nao/camera/video_device.h"

#include <fcntl.h>
#include <poll.h>
#include <sys/ioctl.h>
#include <sys/mman.h>

#include <cerrno>

namespace robot::nao {

int KernelVideoDevice::open(const std::filesystem::path& path) {
  file_ = FileDescriptor(::open(path.c_str(), O_RDWR | O_NONBLOCK | O_CLOEXEC));
  return file_ ? 0 : errno;
}

int KernelVideoDevice::control(unsigned long request, void* argument) {
  int done = 0;
  do done = ::ioctl(file_.get(), request, argument);
  while (done < 0 && errno == EINTR);
  return done < 0 ? errno : 0;
}

void* KernelVideoDevice::map(std::size_t bytes, std::int64_t offset) {
  void* memory = ::mmap(nullptr, bytes, PROT_READ | PROT_WRITE, MAP_SHARED, file_.get(), static_cast<off_t>(offset));
  return memory == MAP_FAILED ? nullptr : memory;
}

void KernelVideoDevice::unmap(void* memory, std::size_t bytes) { ::munmap(memory, bytes); }

bool KernelVideoDevice::wait(int patience_ms) {
  pollfd ready{.fd = file_.get(), .events = POLLIN, .revents = 0};
  return ::poll(&ready, 1, patience_ms) > 0;
}

}  // namespace robot::nao
