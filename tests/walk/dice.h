// Random numbers that stay the same with each library: no distribution of the standard library is used.
#pragma once

#include <cstdint>
#include <random>

namespace robot::nao::walk {

class Dice {
 public:
  explicit Dice(std::uint64_t seed) : bits_(seed) {}

  double uniform() { return static_cast<double>(bits_() >> 11) * 0x1p-53; }
  double between(double low, double high) { return low + (high - low) * uniform(); }
  /// Returns a number with mean 0 and deviation 1: the sum of twelve uniform ones.
  double normal() {
    double sum = -6;
    for (int i = 0; i < 12; ++i) sum += uniform();
    return sum;
  }

 private:
  std::mt19937_64 bits_;
};

}  // namespace robot::nao::walk
