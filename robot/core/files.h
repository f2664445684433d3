// Whole small files in and out.
#pragma once

#include <cstddef>
#include <filesystem>
#include <string>
#include <string_view>
#include <utility>

#include "robot/core/result.h"

namespace robot {

/// The bytes of the file at `path`; an Error if it cannot be read or holds more than `max_bytes`.
Result<std::string> read_file(const std::filesystem::path& path, std::size_t max_bytes);

/// Puts `bytes` at `path` so that a reader sees the old file or the new one, never half: writes beside it, then renames.
/// `mode` are the permission bits of the new file.
Result<void> replace_file(const std::filesystem::path& path, std::string_view bytes, unsigned mode = 0644);

/// "what: path: reason" for the system error `error_number`.
Error file_error(std::string_view what, const std::filesystem::path& path, int error_number);

/// Owns a file descriptor and closes it.
class FileDescriptor {
 public:
  FileDescriptor() = default;
  explicit FileDescriptor(int number) : number_(number) {}
  FileDescriptor(FileDescriptor&& other) noexcept : number_(std::exchange(other.number_, -1)) {}
  FileDescriptor& operator=(FileDescriptor&& other) noexcept;
  ~FileDescriptor() { reset(); }

  int get() const { return number_; }
  explicit operator bool() const { return number_ >= 0; }
  void reset();

 private:
  int number_ = -1;
};

}  // namespace robot
