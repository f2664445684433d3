#include "sim/contest/series.h"

#include <algorithm>
#include <atomic>
#include <system_error>
#include <thread>

namespace sim::contest {

void for_each_game(int games, int threads, const std::function<void(int)>& play,
                   const std::function<void(int)>& progress) {
  std::atomic<int> next = 0, done = 0;
  const auto work = [&](bool tells) {
    for (int game; (game = next++) < games;) {
      play(game);
      const int so_far = ++done;
      if (tells && progress) progress(so_far);
    }
  };
  std::vector<std::thread> others;
  try {
    for (int i = 1; i < std::min(threads, games); ++i) others.emplace_back(work, false);
  } catch (const std::system_error&) {
    // the system allows no more threads: fewer do the same work
  }
  work(true);
  for (std::thread& other : others) other.join();
}

int threads_for(int games) {
  return std::clamp(static_cast<int>(std::thread::hardware_concurrency()), 1, std::max(games, 1));
}

void Problem::tell(const std::string& problem) {
  const std::lock_guard guard(lock_);
  if (text_.empty()) text_ = problem;
}

bool Problem::is_known() const { return !text().empty(); }

std::string Problem::text() const {
  const std::lock_guard guard(lock_);
  return text_;
}

Mean mean_of(const std::vector<double>& values) {
  if (values.empty()) return {};
  const auto count = static_cast<double>(values.size());
  double sum = 0, squares = 0;
  for (const double value : values) sum += value;
  const double mean = sum / count;
  for (const double value : values) squares += (value - mean) * (value - mean);
  return {.mean = mean, .error = values.size() < 2 ? 0 : std::sqrt(squares / (count - 1) / count)};
}

double median_of(std::vector<double> values) {
  if (values.empty()) return 0;
  std::sort(values.begin(), values.end());
  const std::size_t half = values.size() / 2;
  return values.size() % 2 == 1 ? values[half] : (values[half - 1] + values[half]) / 2;
}

}  // namespace sim::contest
