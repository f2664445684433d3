// All messages of one recorded stream.
#pragma once

#include <gtest/gtest.h>

#include <filesystem>
#include <vector>

#include "robot/logging/streams/file_provider.h"

namespace tests {

/// Returns the messages before the first damage.
inline std::vector<robot::logging::Record> read_stream(const std::filesystem::path& path) {
  robot::logging::FileInProvider file(path);
  std::vector<robot::logging::Record> records;
  EXPECT_TRUE(file.open()) << path;
  while (true) {
    auto record = file.read();
    if (!record || !*record) return records;
    records.push_back(std::move(**record));
  }
}

}  // namespace tests
