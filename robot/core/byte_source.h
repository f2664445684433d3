// A source of bytes: a file, or memory in tests.
#pragma once

#include <cstdint>
#include <filesystem>
#include <memory>
#include <span>
#include <string>
#include <utility>

#include "robot/core/files.h"
#include "robot/core/result.h"

namespace robot {

/// A sequence of bytes with random access. Any thread.
class ByteSource {
 public:
  virtual ~ByteSource() = default;

  /// Returns the name for error sentences: the file's name without its folder.
  virtual const std::string& name() const = 0;

  /// Returns the number of bytes. It does not change, even if the file grows.
  virtual std::uint64_t size() const = 0;

  /// Fills `into` with the bytes from `offset` on. Returns an Error if there are not enough.
  virtual Result<void> read(std::uint64_t offset, std::span<char> into) const = 0;
};

/// Returns `length` bytes of `source` from `offset` on. Allocates nothing if there are not enough.
Result<std::string> read_bytes(const ByteSource& source, std::uint64_t offset, std::uint64_t length);

/// Whether a symbolic link is opened as the file that it names.
enum class Links { follow, refuse };

/// A file with the size that it had when it was opened.
class FileSource final : public ByteSource {
 public:
  /// Opens the file at `path`. Returns an Error for a folder, a pipe or a device, without waiting for its other end.
  static Result<std::shared_ptr<const FileSource>> open(const std::filesystem::path& path, Links links = Links::follow);

  /// Returns the bytes of an open file. `path` is its name in sentences. Returns an Error for a folder, a pipe or a device.
  static Result<std::shared_ptr<const FileSource>> of(const std::filesystem::path& path, FileDescriptor file);

  const std::string& name() const override { return name_; }
  std::uint64_t size() const override { return size_; }
  Result<void> read(std::uint64_t offset, std::span<char> into) const override;

 private:
  FileSource(std::filesystem::path path, FileDescriptor file, std::uint64_t size);

  std::filesystem::path path_;
  std::string name_;
  FileDescriptor file_;
  std::uint64_t size_;
};

/// Bytes in memory.
class MemorySource final : public ByteSource {
 public:
  explicit MemorySource(std::string bytes, std::string name = "memory")
      : bytes_(std::move(bytes)), name_(std::move(name)) {}

  const std::string& name() const override { return name_; }
  std::uint64_t size() const override { return bytes_.size(); }
  Result<void> read(std::uint64_t offset, std::span<char> into) const override;

 private:
  std::string bytes_, name_;
};

}  // namespace robot
