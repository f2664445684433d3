// Many games at once, each on one thread. The result is the same for any number of threads.
#pragma once

#include <cmath>
#include <cstdint>
#include <functional>
#include <mutex>
#include <string>
#include <vector>

namespace sim::contest {

/// Calls `play(i)` for 0 <= i < games, from `threads` threads. `progress` gets the number of finished games, in one thread.
void for_each_game(int games, int threads, const std::function<void(int)>& play,
                   const std::function<void(int)>& progress = {});

/// Returns the number of processors, at most `games`.
int threads_for(int games);

/// The first fault in many games. Any thread.
class Problem {
 public:
  /// Notes a fault. Only the first one is kept.
  void tell(const std::string& problem);
  bool is_known() const;
  /// Returns the fault, or an empty string.
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
/// Returns the median: the mean of the middle two for an even number of values, 0 for none.
double median_of(std::vector<double> values);

}  // namespace sim::contest
