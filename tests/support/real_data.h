// Real recordings for tests, in the folder that the environment variable FORESIGHT_DATA names; not in the repository.
#pragma once

#include <gtest/gtest.h>

#include <cstdlib>
#include <filesystem>
#include <optional>
#include <string_view>

namespace tests {

/// Returns the file `relative` in the folder $FORESIGHT_DATA, or nothing if that is unset or has no such file.
inline std::optional<std::filesystem::path> real_data(std::string_view relative) {
  const char* folder = std::getenv("FORESIGHT_DATA");
  if (folder == nullptr) return std::nullopt;
  std::filesystem::path path = std::filesystem::path(folder) / relative;
  std::error_code error;
  if (!std::filesystem::is_regular_file(path, error)) return std::nullopt;
  return path;
}

/// True if a missing recording is a failure instead of a skip: FORESIGHT_REQUIRE_DATA=1.
inline bool real_data_required() {
  const char* required = std::getenv("FORESIGHT_REQUIRE_DATA");
  return required != nullptr && std::string_view(required) == "1";
}

}  // namespace tests

/// Defines `path` as the real recording `relative`, or ends the test as skipped, or as failed if data are required.
#define REAL_DATA_OR_SKIP(path, relative)                                                                        \
  const std::optional<std::filesystem::path> path##_found = ::tests::real_data(relative);                        \
  if (!path##_found && ::tests::real_data_required()) FAIL() << relative << " is not in $FORESIGHT_DATA";        \
  if (!path##_found) GTEST_SKIP() << "needs the recording " << relative << "; set FORESIGHT_DATA to its folder"; \
  const std::filesystem::path& path = *path##_found
