// Many games at once: each on one thread, the result the same however many threads there are.
#pragma once

#include <cmath>
#include <cstdint>
#include <functional>
#include <mutex>
#include <string>
#include <vector>

namespace sim::contest {

/// Calls `play(i)` for 0 <= i < games, from `threads` threads; `progress` hears how many are done, in one thread.
void for_each_game(int games, int threads, const std::function<void(int)>& play,
                   const std::function<void(int)>& progress = {});

/// As many threads as the machine has processors, but not more than games.
int threads_for(int games);

/// What went wrong in one of many games; any thread.
class Problem {
 public:
  /// The first one counts.
  void tell(const std::string& problem);
  bool is_known() const;
  /// Empty: nothing did.
  std::string text() const;

 private:
  mutable std::mutex lock_;
  std::string text_;
};

/// A mean, and how far it may be off.
struct Mean {
  double mean = 0;
  double error = 0;  // one standard error; 0 of fewer than two values
};
Mean mean_of(const std::vector<double>& values);
/// Of an even number, the mean of the middle two; 0 of none.
double median_of(std::vector<double> values);

}  // namespace sim::contest
