// The protocol with a behaviour in a process of its own: one JSON object per line, with the names and units of
// sim/guest/foresight_behaviour.h. A time that never was is null. Robots never heard or seen are left out. Truth values
// are true and false, enumerations are words.
//
//   we   {"version": 1, "players": 4, "seed": 7, "field": {"length": 9, …},
//         "walk": {"forward": 0.3, …}, "kicks": [{…}]}
//   it   {"version": 1, "name": "charge"}
//   we   {"player": 2, "now": 451, "entered": true, "phase": "playing", …, "ball": {"seen": 450, "x": 1.5, …},
//         "mates": [{"player": 3, …}], "opponents": [{"player": 1, …}]}
//   it   {"body": "walk_to", "x": 1.2, "y": 0, "turn": 0.1, "role": "chaser", "time_to_ball": 4.5}
//
// One process plays all robots of a side in one game, and separates their memories by "player". The end of the game
// closes its input. Each entry of an answer is optional; {} means the defaults.
#pragma once

#include <string>

#include "sim/guest/foresight_behaviour.h"

namespace sim::guest {

/// The greeting and a question, each as a line with its line feed.
std::string greeting_of(const ForesightPlayer& player);
std::string question_of(const ForesightPlayer& player, const ForesightMoment& moment);

/// Returns the error in the answer to the greeting, or an empty text.
std::string check_greeting(const std::string& answer);

/// Reads an answer into the command. Returns an error, or an empty text.
std::string read_answer(const std::string& answer, const ForesightPlayer& player, ForesightCommand& command);

}  // namespace sim::guest
