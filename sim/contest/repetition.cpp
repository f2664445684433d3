#include "sim/contest/repetition.h"

#include <algorithm>

namespace sim::contest {

std::int64_t different_games(std::vector<std::uint64_t> hashes) {
  std::ranges::sort(hashes);
  return std::unique(hashes.begin(), hashes.end()) - hashes.begin();
}

std::string repetition(std::int64_t expected, std::int64_t different, const char* what, const std::string& models) {
  return "the games repeat: expected " + std::to_string(expected) + " different " + what + ", got " +
         std::to_string(different) + "; with models '" + models +
         "' a seed changes too little: choose models with noise, or vary the start with --from and --fuzz";
}

}  // namespace sim::contest
