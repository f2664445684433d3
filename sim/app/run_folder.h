// A comparison on the disk: what is compared, and block by block what came of it. What was killed goes on from there.
#pragma once

#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "robot/core/result.h"
#include "sim/compare/tally.h"

namespace sim::app {

/// Each block is a file that is there as a whole or not at all. Any thread, each block by one.
class RunFolder {
 public:
  static constexpr std::int64_t kPairsPerBlock = 25;

  /// Opens or makes the folder of a run. A folder that holds another run is refused; one that holds this run only goes on
  /// where that is asked for.
  static robot::Result<RunFolder> open(const std::filesystem::path& folder, const std::string& specification,
                                       bool resume);

  /// The pairs of a block, if they are there. A file that is damaged or of another run counts as not there.
  std::optional<std::vector<compare::Pair>> read(std::int64_t block) const;

  robot::Result<void> write(std::int64_t block, const std::vector<compare::Pair>& pairs) const;

 private:
  RunFolder(std::filesystem::path folder, std::string run) : folder_(std::move(folder)), run_(std::move(run)) {}

  std::filesystem::path path_of(std::int64_t block) const;

  std::filesystem::path folder_;
  std::string run_;  // the hash of its specification
};

}  // namespace sim::app
