// Appending of bytes to a file, and truncation after a failure.
#pragma once

#include <cstdint>
#include <filesystem>
#include <memory>
#include <span>
#include <string>
#include <string_view>

#include "robot/core/files.h"
#include "robot/core/result.h"

namespace robot {

/// A run of bytes that grows at its end. Used by one thread.
class ByteSink {
 public:
  virtual ~ByteSink() = default;

  /// Appends `pieces` one after the other. After an Error a part of them may have been appended.
  virtual Result<void> append(std::span<const std::string_view> pieces) = 0;

  /// Removes everything after the first `size` bytes.
  virtual Result<void> truncate(std::uint64_t size) = 0;
};

/// A new file.
class FileSink final : public ByteSink {
 public:
  /// Creates the file at `path`. Returns an Error if it exists, because recordings are never overwritten.
  static Result<std::unique_ptr<FileSink>> create(const std::filesystem::path& path);

  /// Returns a sink that appends to an open file. `path` is its name in sentences.
  static std::unique_ptr<FileSink> of(const std::filesystem::path& path, FileDescriptor file);

  Result<void> append(std::span<const std::string_view> pieces) override;
  Result<void> truncate(std::uint64_t size) override;

 private:
  FileSink(std::filesystem::path path, FileDescriptor file);

  std::filesystem::path path_;
  FileDescriptor file_;
};

/// Bytes in memory.
class MemorySink final : public ByteSink {
 public:
  /// `bytes` outlives the sink.
  explicit MemorySink(std::string& bytes) : bytes_(bytes) {}

  Result<void> append(std::span<const std::string_view> pieces) override {
    for (const std::string_view piece : pieces) bytes_ += piece;
    return {};
  }
  Result<void> truncate(std::uint64_t size) override {
    bytes_.resize(static_cast<std::size_t>(size));
    return {};
  }

 private:
  std::string& bytes_;
};

}  // namespace robot
