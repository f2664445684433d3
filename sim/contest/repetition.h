// Games that repeat: a series in which the seed changes too little is no sample.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

namespace sim::contest {

/// Returns the number of different games, given the hash of each (hash_of_game).
std::int64_t different_games(std::vector<std::uint64_t> hashes);

/// Returns the sentence about a series with fewer different games than expected. `what` is "games" or "pairs"; `models`
/// is the name of the models of the robots.
std::string repetition(std::int64_t expected, std::int64_t different, const char* what, const std::string& models);

}  // namespace sim::contest
