// Random numbers for the pixels of an image.
#pragma once

#include <cstdint>

namespace robot::truth {

/// A sequence of random bits, the same on all machines.
class RandomBits {
 public:
  explicit RandomBits(std::uint64_t seed) : state_(mixed(seed)) {}

  /// Returns a number below 65536.
  std::uint32_t next() {
    // Marsaglia's xorshift
    state_ ^= state_ << 13;
    state_ ^= state_ >> 7;
    state_ ^= state_ << 17;
    return static_cast<std::uint32_t>(state_ >> 48);
  }

 private:
  /// Spreads neighbouring seeds over all values but 0 (splitmix64).
  static std::uint64_t mixed(std::uint64_t seed) {
    seed += 0x9e3779b97f4a7c15;
    seed = (seed ^ (seed >> 30)) * 0xbf58476d1ce4e5b9;
    seed = (seed ^ (seed >> 27)) * 0x94d049bb133111eb;
    return (seed ^ (seed >> 31)) | 1;
  }

  std::uint64_t state_;
};

}  // namespace robot::truth
