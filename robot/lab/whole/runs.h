// Words of a recording over time: how long a field kept its value.
#pragma once

#include <cstdint>
#include <map>
#include <string>
#include <vector>

namespace robot::lab {

/// A time during which the words stayed the same.
struct Run {
  std::uint64_t from_ns = 0, to_ns = 0;   // capture times; to_ns: of the next run's begin, or of the last message
  std::vector<std::uint32_t> words = {};  // one for each field: index in Runs::words
};

/// The runs of some fields, in order of time. A run ends where a message says something else, and where none comes for
/// kGapNs: then the robot was away.
class Runs {
 public:
  static constexpr std::uint64_t kGapNs = 2'000'000'000;
  static constexpr std::size_t kMost = 50'000;       // runs; later ones are left out
  static constexpr std::size_t kMostWords = 10'000;  // different words; later ones are "…"

  /// Adds a message with these words, one for each field. Times must not go back; messages that do are left out.
  void add(std::uint64_t at_ns, const std::vector<std::string>& words);

  const std::vector<Run>& runs() const { return runs_; }
  const std::vector<std::string>& words() const { return words_; }
  bool full() const { return full_; }  // runs were left out

 private:
  std::uint32_t index_of(const std::string& word);

  std::vector<Run> runs_;
  std::vector<std::string> words_;
  std::map<std::string, std::uint32_t, std::less<>> index_;
  bool full_ = false;
};

}  // namespace robot::lab
