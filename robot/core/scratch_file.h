// A file for intermediate data.
#pragma once

#include <filesystem>
#include <memory>

#include "robot/core/byte_sink.h"
#include "robot/core/byte_source.h"
#include "robot/core/files.h"
#include "robot/core/result.h"

namespace robot {

/// A file without a name. The system frees its space when nobody has it open any more, also after the death of the
/// process. Used by one thread.
class ScratchFile {
 public:
  /// Makes an empty file on the disk of `folder`.
  static Result<ScratchFile> make(const std::filesystem::path& folder);

  /// Returns a sink that appends to the file.
  Result<std::unique_ptr<ByteSink>> sink() const;

  /// Returns the bytes that were written until now.
  Result<std::shared_ptr<const ByteSource>> source() const;

 private:
  ScratchFile(std::filesystem::path path, FileDescriptor file) : path_(std::move(path)), file_(std::move(file)) {}

  std::filesystem::path path_;  // for sentences
  FileDescriptor file_;
};

}  // namespace robot
