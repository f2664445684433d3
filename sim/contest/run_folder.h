// A comparison on the disk: what is compared, and block by block what came of it. What was killed goes on from there.
#pragma once

#include <cstdint>
#include <filesystem>
#include <string>
#include <vector>

#include "robot/core/files.h"
#include "robot/core/result.h"
#include "sim/compare/pair_statistics.h"

namespace sim::contest {

/// Each block is a file that is there as a whole or not at all. Any thread, each block by one.
class RunFolder {
 public:
  static constexpr std::int64_t kPairsPerBlock = 25;

  /// What somebody wants of a run.
  enum class Use {
    begin,  // nothing is there
    go_on,  // what is there is this run
    share,  // likewise, and others write other blocks of it meanwhile
  };

  /// Opens or makes the folder of a run. A folder that holds another run is refused, and one that somebody else is using,
  /// unless all of them share it.
  static robot::Result<RunFolder> open(const std::filesystem::path& folder, const std::string& specification, Use use);

  /// The pairs of a block; an Error where it is missing, damaged or of another run.
  robot::Result<std::vector<compare::Pair>> read(std::int64_t block) const;

  /// There is a file for that block, whatever is in it.
  bool has(std::int64_t block) const;

  robot::Result<void> write(std::int64_t block, const std::vector<compare::Pair>& pairs) const;

  /// How many blocks there are if none is missing: one more than the last.
  std::int64_t blocks() const;

  /// What was found, without what hangs on the machine: result.json.
  robot::Result<void> write_result(const std::string& json) const;

  const std::filesystem::path& path() const { return folder_; }

 private:
  RunFolder(std::filesystem::path folder, std::string run) : folder_(std::move(folder)), run_(std::move(run)) {}
  robot::Result<void> lock(Use use);

  std::filesystem::path path_of(std::int64_t block) const;

  std::filesystem::path folder_;
  std::string run_;  // the hash of its specification
  robot::FileDescriptor lock_;
};

}  // namespace sim::contest
