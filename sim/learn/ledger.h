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
#include "sim/learn/share.h"

namespace sim::learn {

/// The result of one attempt at an exercise, or of one game.
struct Score {
  float points = 0;  // of a drill: its score; of a game: own goals less theirs
  bool won = false;  // the attempt succeeded; the game was won

  friend bool operator==(const Score&, const Score&) = default;
};

/// The results by the hash of what was played. Each process of a run writes a file of its own, ledger-NUMBER.txt, and reads
/// those of the others. A run without a folder keeps them in memory only. Used by one thread at a time.
class Ledger {
 public:
  /// Reads the ledgers in `folder`, which exists, and begins or goes on with that of `share`; an empty path keeps everything
  /// in memory. Drops the last line of its own ledger if a kill cut it off. An Error names a damaged line, or says that
  /// another process has this share.
  static robot::Result<Ledger> open(const std::filesystem::path& folder, Share share = {});

  /// Returns the scores, or nullptr. They stay where they are.
  const std::vector<Score>* find(std::uint64_t key) const;

  /// Reads the whole lines that other processes of the run have written since.
  robot::Result<void> refresh();

  /// Adds the scores, and writes them at the end of the own file.
  robot::Result<void> add(std::uint64_t key, std::vector<Score> scores);

  std::size_t size() const { return scores_.size(); }
  Share share() const { return share_; }

 private:
  /// The whole lines of a file that are read.
  struct Known {
    std::uint64_t bytes = 0;
    int lines = 0;
  };

  robot::Result<void> read_on(const std::string& name);

  std::filesystem::path folder_;
  std::string own_;  // name of the own file
  Share share_;
  robot::FileDescriptor open_;
  std::map<std::string, Known> known_;  // by the name of the file
  std::map<std::uint64_t, std::vector<Score>> scores_;
};

}  // namespace sim::learn
