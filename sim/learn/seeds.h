// The seeds of a run: disjoint by purpose, so that no game that chose a tree also judges it.
#pragma once

#include <cstdint>
#include <string>

namespace sim::learn {

enum class Purpose : std::uint8_t { training, held_out, selection, test };

/// Hands out seeds. A run's seeds of different purposes, and those of runs with other seeds, are disjoint.
class Seeds {
 public:
  /// The seed of a run: 0 .. kMostRun.
  static constexpr std::uint64_t kMostRun = (std::uint64_t{1} << 16) - 1;
  explicit Seeds(std::uint64_t run) : run_(run) {}

  /// Returns the first of `count` seeds in a row that nobody had before.
  std::uint64_t take(Purpose purpose, std::uint64_t count) {
    std::uint64_t& used = used_[static_cast<int>(purpose)];
    const std::uint64_t first = first_of(purpose) + used;
    used += count;
    return first;
  }
  /// Returns the seed that take() gives first.
  std::uint64_t first_of(Purpose purpose) const { return (static_cast<std::uint64_t>(purpose) << 50) + (run_ << 34); }
  std::uint64_t used(Purpose purpose) const { return used_[static_cast<int>(purpose)]; }

 private:
  std::uint64_t run_;
  std::uint64_t used_[4] = {};
};

}  // namespace sim::learn
