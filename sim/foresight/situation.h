// The start of a question: one robot's beliefs about the game as a state to play on from, with its uncertainty.
#pragma once

#include <string>

#include "sim/agent/beliefs.h"
#include "sim/agent/mind.h"
#include "sim/match/params.h"
#include "sim/match/state.h"

namespace sim::foresight {

/// The knowledge of a robot about the game. All times are ticks of one count; `now` is the present.
/// Frame: team_field, as in beliefs.
struct Knowledge {
  Tick now = 0;
  agent::Game game;        // with the number of the robot
  agent::Beliefs beliefs;  // a robot that was never localised has a deviation above kLost
  agent::Mind mind;        // memory of its agent
  Body body;               // its action and motion; its place is in beliefs
  // of all robots, own side first:
  Tick away[2][kMaxPlayers] = {};  // [ticks] until a penalised robot may come back; 0: plays, kNever: does not play
  Tick down[2][kMaxPlayers] = {};  // last time it was reported or seen on the ground; 0: it stands
};

/// Returns the knowledge of `robot` in a simulated game.
Knowledge knowledge_of(const Params& params, const State& state, int robot);

/// The uncertainty of a situation: one standard deviation along each axis.
struct Doubt {
  std::uint8_t whose = kNobody;     // robot with these beliefs; kNobody: all beliefs stay unchanged
  float ball = 0;                   // [m]
  float ball_velocity = 0;          // [m/s]
  float ball_elsewhere = 0;         // [0..1] probability that it lies elsewhere on the field
  bool ball_by_own_eyes = false;    // an error of that robot's pose moves the ball too
  float position[kMaxRobots] = {};  // [m]
  float heading[kMaxRobots] = {};   // [rad]
};

/// A moment of a game with its uncertainty.
struct Situation {
  State state;  // the most likely one
  Doubt doubt;
};

/// A robot with a greater deviation does not know where it is.
inline constexpr float kLost = 1.5f;  // [m]
/// The ball cannot be guessed when nobody has seen it for longer.
inline constexpr float kBallLost = 30;  // [s]

/// The situation that a robot believes in, or the reason why there is none. Its own side is home and attacks +x:
/// `field` of the state is its `team_field`.
///
/// Teammates are where they reported, opponents where they were seen, less certain with age. A robot never heard or
/// seen stands at its place in the formation. All play with the knowledge of the whole team.
struct Believed {
  Situation situation;
  std::string refusal;  // "the robot does not know where it is: …"; empty when there is a situation
};
Believed believe(const Params& params, const Knowledge& knowledge);

/// A part of the true state that may be revealed.
struct Insight {
  bool ball = false, own_side = false, opponents = false;
};

/// Replaces a belief of a robot of side `own` by the truth, and removes its uncertainty. `truth` is the world at the
/// same tick. A robot off the field, by belief or in truth, stays unchanged. The beliefs
/// of the robots in the state stay.
void tell(const World& truth, Side own, Insight insight, Situation& situation);

/// Draws one of the possible worlds of the situation by `key` (event `belief`), to be played on with that key. The
/// beliefs of the robot and its team about the ball stay, and its belief about its own pose; the world differs. The
/// others know their own places, and the opponents know the ball. A ball beyond a line is placed
/// elsewhere, as the referee would.
State sample(const Params& params, const Situation& situation, RandomKey key);

}  // namespace sim::foresight
