// Reading and writing of whole small files. Nothing here throws for a system error.
#pragma once

#include <cstddef>
#include <filesystem>
#include <string>
#include <string_view>
#include <utility>

#include "robot/core/result.h"

namespace robot {

/// Returns the bytes of the file at `path`, or an Error if it cannot be read or holds more than `max_bytes`.
Result<std::string> read_file(const std::filesystem::path& path, std::size_t max_bytes);

/// Replaces the file at `path` by `bytes`. A reader sees the old file or the new one, never half a file: the function
/// writes a file beside it and renames that one. Threads, processes and other machines may replace one file at the same
/// time; it then holds the bytes of one of them. `mode` holds the permission bits of the new file.
Result<void> replace_file(const std::filesystem::path& path, std::string_view bytes, unsigned mode = 0644);

/// Returns `path` from the root, without "." and "..", and without a slash at its end. A path that the system cannot complete
/// is returned as it is.
std::filesystem::path absolute_path(const std::filesystem::path& path);

/// As replace_file(), and returns only when the disk holds the file and its name, so that a loss of power leaves the old
/// file or the new one.
Result<void> store_file(const std::filesystem::path& path, std::string_view bytes, unsigned mode = 0644);

/// Returns the Error "WHAT PATH: reason" for the system error `error_number`.
Error file_error(std::string_view what, const std::filesystem::path& path, int error_number);

/// A file descriptor that is closed by its owner's destructor.
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

/// Returns a file descriptor of no use. Its owner closes it when no other is left, and can then accept one connection to
/// refuse it with a sentence. Empty if none is left.
FileDescriptor spare_descriptor();

/// Returns whether the system error `error_number` means that no file descriptor is left, of the process or the system.
bool is_out_of_descriptors(int error_number);

}  // namespace robot
