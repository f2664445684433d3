// A 64-bit hash of states.
#pragma once

#include <cstdint>
#include <string>
#include <string_view>

#include "sim/match/state.h"

namespace sim {

/// A hash of a sequence of numbers. The same numbers in the same order have the same hash on every machine.
/// It multiplies and rotates for each number and ends with an avalanche, so each input
/// bit affects each bit of the hash.
class Hash {
 public:
  void add(std::uint64_t number) {
    hash_ = (hash_ ^ (number * 0x9e3779b97f4a7c15u)) * 0xff51afd7ed558ccdu;
    hash_ = hash_ << 29 | hash_ >> 35;
  }
  std::uint64_t value() const {
    std::uint64_t value = hash_;
    value = (value ^ (value >> 33)) * 0xc4ceb9fe1a85ec53u;
    value = (value ^ (value >> 29)) * 0x94d049bb133111ebu;
    return value ^ (value >> 32);
  }

 private:
  std::uint64_t hash_ = 0x243f6a8885a308d3u;  // digits of π
};

/// Returns the hash of a text's bytes.
std::uint64_t hash_of_text(std::string_view text);

/// Returns the hash of the bits of every field of a state.
std::uint64_t hash_of(const State& state);

/// Returns the hash of all that has happened in a game: the state without its seed and without the memories of the agents.
/// Two strategies that act alike, or two seeds that change nothing, have the same hash.
std::uint64_t hash_of_game(const State& state);

/// Returns the hash as 16 hexadecimal digits.
std::string hex(std::uint64_t hash);

}  // namespace sim
