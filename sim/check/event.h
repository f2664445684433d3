// Events that a situation prescribes: "at 5 s: penalise home/3", "at 8 s: ball at 1.2 m, 0.5 m". Where the situation
// names the numbers of its teams, "14/3" is player 3 of team 14.
#pragma once

#include <string>
#include <string_view>

#include "robot/core/result.h"
#include "sim/io/situation.h"
#include "sim/match/params.h"
#include "sim/match/state.h"

namespace sim::check {

/// An event at a time since the start of the game.
struct Event {
  enum class Kind { penalise, ball };
  Kind kind = Kind::penalise;
  Tick at = 0;
  int robot = kNobody;  // index of the penalised robot
  Vec2 ball = {};       // [m, field] new place of the ball, at rest
};

/// Parses the name of a robot, "home/3" or "14/3", as its index, or returns kNobody.
int robot_named(std::string_view text, int players, const io::SituationTeams& teams);
/// Returns the names that a robot may have, for an error: "home/N, away/N, 14/N or 5/N, N from 1 to 4".
std::string robot_names(int players, const io::SituationTeams& teams);

/// Parses an event of a game with `players` a side. `teams` are those of the situation.
robot::Result<Event> parse_event(std::string_view text, int players, const io::SituationTeams& teams = {});

/// Lets the event happen now. A penalised robot leaves as if the referee had removed it for pushing; one that is off
/// the field stays there.
void apply(const Event& event, const Params& params, State& state);

}  // namespace sim::check
