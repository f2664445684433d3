// The ledger of a run: the results of all exercises that were played, so that a killed run goes on where it was.
#pragma once

#include <cstdint>
#include <filesystem>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "robot/core/files.h"
#include "robot/core/result.h"

namespace sim::learn {

/// The result of one attempt at an exercise, or of one game.
struct Score {
  float points = 0;  // of a drill: its score; of a game: own goals less theirs
  bool won = false;  // the attempt succeeded; the game was won

  friend bool operator==(const Score&, const Score&) = default;
};

/// The results by the hash of what was played. A run without a folder keeps them in memory only. Used by one thread at a time.
class Ledger {
 public:
  /// Reads the ledger in `file`, or begins it; an empty path keeps everything in memory. Drops a last line that a kill cut
  /// off. An Error names a damaged line.
  static robot::Result<Ledger> open(const std::filesystem::path& file);

  /// Returns the scores, or nullptr.
  const std::vector<Score>* find(std::uint64_t key) const;

  /// Adds the scores, and writes them at the end of the file.
  robot::Result<void> add(std::uint64_t key, std::vector<Score> scores);

  std::size_t size() const { return scores_.size(); }

 private:
  std::filesystem::path file_;
  robot::FileDescriptor open_;
  std::map<std::uint64_t, std::vector<Score>> scores_;
};

}  // namespace sim::learn
