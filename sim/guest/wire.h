// The lines that are spoken with a behaviour in a process of its own: one JSON object each, the names and units of
// sim/guest/foresight_behaviour.h. What never happened is null, whoever was never heard or seen is left out, truth
// values are true and false, enumerations are words.
//
//   we   {"version": 1, "players": 4, "seed": 7, "field": {"length": 9, …}, "walk": {"forward": 0.3, …}, "kicks": [{…}]}
//   it   {"version": 1, "name": "charge"}
//   we   {"player": 2, "now": 451, "entered": true, "phase": "playing", …, "ball": {"seen": 450, "x": 1.5, …},
//         "mates": [{"player": 3, …}], "opponents": [{"player": 1, …}]}
//   it   {"body": "walk_to", "x": 1.2, "y": 0, "turn": 0.1, "role": "chaser", "time_to_ball": 4.5}
//
// One process plays all robots of a side in one game, and keeps their memories apart by "player". A game that ends closes
// its input. In an answer everything may be left out; {} is the usual.
#pragma once

#include <string>

#include "sim/guest/foresight_behaviour.h"

namespace sim::guest {

/// Each ends with a line's end.
std::string greeting_of(const ForesightPlayer& player);
std::string question_of(const ForesightPlayer& player, const ForesightMoment& moment);

/// What is wrong with the answer to the greeting; empty where nothing is.
std::string check_greeting(const std::string& answer);

/// Puts an answer into the command; what is wrong with it, or empty.
std::string read_answer(const std::string& answer, const ForesightPlayer& player, ForesightCommand& command);

}  // namespace sim::guest
