// A comparison on the disk: its specification and the results of each block. A killed run continues from there.
#pragma once

#include <cstdint>
#include <filesystem>
#include <string>
#include <vector>

#include "robot/core/files.h"
#include "robot/core/result.h"
#include "sim/compare/pair_statistics.h"

namespace sim::contest {

/// The folder of a run. Each block is a file that exists completely or not at all. Any thread; each block by one thread.
class RunFolder {
 public:
  static constexpr std::int64_t kPairsPerBlock = 25;

  /// The purpose of opening a run.
  enum class Use {
    begin,  // a new run
    go_on,  // the folder holds this run
    share,  // the same, and other processes write other blocks at the same time
  };

  /// Opens or creates the folder of a run. Returns an Error if it holds another run, or if another process uses it and not
  /// both share it.
  static robot::Result<RunFolder> open(const std::filesystem::path& folder, const std::string& specification, Use use);

  /// Returns the pairs of a block, or an Error if it is missing, damaged or of another run.
  robot::Result<std::vector<compare::Pair>> read(std::int64_t block) const;

  /// Reports whether the block has a file, of any content.
  bool has(std::int64_t block) const;

  robot::Result<void> write(std::int64_t block, const std::vector<compare::Pair>& pairs) const;

  /// Returns the number of the last block plus one.
  std::int64_t blocks() const;

  /// Writes result.json: the result without the figures that depend on the machine.
  robot::Result<void> write_result(const std::string& json) const;

  const std::filesystem::path& path() const { return folder_; }

 private:
  RunFolder(std::filesystem::path folder, std::string run) : folder_(std::move(folder)), run_(std::move(run)) {}
  robot::Result<void> lock(Use use);

  std::filesystem::path path_of(std::int64_t block) const;

  std::filesystem::path folder_;
  std::string run_;  // hash of the specification
  robot::FileDescriptor lock_;
};

}  // namespace sim::contest
