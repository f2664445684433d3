#include "sim/app/cycles.h"

#include <time.h>

#include <algorithm>

namespace sim::app {
namespace {

constexpr int kTries = 5;
constexpr int kRounds = 20'000;
constexpr int kAdditions = 32;  // per round; the loop's counter runs in parallel

/// Adds in a whole register. The compiler cannot optimise it away.
inline void add(std::uintptr_t& sum, std::uintptr_t number) {
  sum += number;
  asm volatile("" : "+r"(sum));
}

}  // namespace

std::uint64_t computed_ns() {
  timespec time{};
  clock_gettime(CLOCK_THREAD_CPUTIME_ID, &time);
  return static_cast<std::uint64_t>(time.tv_sec) * 1'000'000'000 + static_cast<std::uint64_t>(time.tv_nsec);
}

double cycles_per_ns() {
  std::uint64_t best = ~std::uint64_t{0};
  std::uintptr_t sum = 0, step = 3;
  asm volatile("" : "+r"(step));
  for (int i = 0; i < kTries; ++i) {
    const std::uint64_t begin = computed_ns();
    for (int round = 0; round < kRounds; ++round) {
#pragma GCC unroll 32
      for (int addition = 0; addition < kAdditions; ++addition) add(sum, step);
    }
    best = std::min(best, computed_ns() - begin);
  }
  return static_cast<double>(kRounds) * kAdditions / static_cast<double>(std::max<std::uint64_t>(best, 1));
}

}  // namespace sim::app
