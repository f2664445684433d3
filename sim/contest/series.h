// Many games at once, each on one thread. The result is the same for any number of threads.
#pragma once

#include <cmath>
#include <cstdint>
#include <functional>
#include <mutex>
#include <string>
#include <vector>

namespace sim::contest {

/// Calls `play(i)` for 0 <= i < games, from `threads` threads. Calls `progress` with the number of finished games,
/// always from the calling thread.
void for_each_game(int games, int threads, const std::function<void(int)>& play,
                   const std::function<void(int)>& progress = {});

/// Returns the number of the machine's processors, but at most `games` and at least 1.
int threads_for(int games);

/// The first failure in many games. Thread-safe.
class Problem {
 public:
  /// Keeps the first problem; later calls have no effect.
  void tell(const std::string& problem);
  bool is_known() const;
  /// Returns the problem, or an empty string without one.
  std::string text() const;

 private:
  mutable std::mutex lock_;
  std::string text_;
};

/// A mean and its standard error.
struct Mean {
  double mean = 0;
  double error = 0;  // one standard error; 0 for fewer than two values
};
Mean mean_of(const std::vector<double>& values);
/// Returns the median: for an even number of values the mean of the middle two, and 0 for none.
double median_of(std::vector<double> values);

}  // namespace sim::contest
