// A video device of the kernel, or a stand-in for one.
#pragma once

#include <cstddef>
#include <cstdint>
#include <filesystem>

#include "robot/core/files.h"

namespace robot::nao {

/// The calls to a Video4Linux device. They return 0, or an error number (errno) if they fail.
class VideoDevice {
 public:
  virtual ~VideoDevice() = default;

  virtual int open(const std::filesystem::path& path) = 0;
  virtual void close() = 0;
  virtual int control(unsigned long request, void* argument) = 0;  // ioctl
  virtual void* map(std::size_t bytes, std::int64_t offset) = 0;   // nullptr: failure
  virtual void unmap(void* memory, std::size_t bytes) = 0;
  virtual bool wait(int patience_ms) = 0;  // for a frame or an error; false: timeout
};

class KernelVideoDevice final : public VideoDevice {
 public:
  int open(const std::filesystem::path& path) override;
  void close() override { file_.reset(); }
  int control(unsigned long request, void* argument) override;
  void* map(std::size_t bytes, std::int64_t offset) override;
  void unmap(void* memory, std::size_t bytes) override;
  bool wait(int patience_ms) override;

 private:
  FileDescriptor file_;
};

}  // namespace robot::nao
