// A comparison on the disk: its specification, and the results block by block. A killed run resumes from it.
#pragma once

#include <cstdint>
#include <filesystem>
#include <string>
#include <vector>

#include "robot/core/files.h"
#include "robot/core/result.h"
#include "sim/compare/pair_statistics.h"

namespace sim::contest {

/// The folder of a run. Each block is a file that is complete or absent. Thread-safe if each block has one writer.
class RunFolder {
 public:
  static constexpr std::int64_t kPairsPerBlock = 25;
  /// The version of the files, in the specification as "format". Increment it when the contents change their meaning.
  static constexpr int kFormat = 2;

  /// The use of a run's folder.
  enum class Use {
    begin,  // the folder holds no run
    go_on,  // the folder may hold this run
    share,  // likewise, and other processes write other blocks meanwhile
  };

  /// Opens or creates the folder of a run. Refuses a folder that holds another run or another format, or that another
  /// process uses, unless all processes share it.
  static robot::Result<RunFolder> open(const std::filesystem::path& folder, const std::string& specification, Use use);

  /// Returns the pairs of a block, or an Error if it is missing, damaged or of another run.
  robot::Result<std::vector<compare::Pair>> read(std::int64_t block) const;

  /// Returns true if there is a file for this block, valid or not.
  bool has(std::int64_t block) const;

  robot::Result<void> write(std::int64_t block, const std::vector<compare::Pair>& pairs) const;

  /// Returns the number of the last block plus one: the number of blocks if none is missing.
  std::int64_t blocks() const;

  /// Writes result.json: the results without figures that depend on the machine.
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
