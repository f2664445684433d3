// Where foresight begins: what one robot believes of the game, as a state to play on from, and how sure it is of it.
#pragma once

#include <string>

#include "sim/agent/beliefs.h"
#include "sim/agent/mind.h"
#include "sim/match/params.h"
#include "sim/match/state.h"

namespace sim::foresight {

/// All that a robot knows of the game. Times are ticks of one count in which `now` is now.
/// Frame: team_field, as beliefs have it.
struct Knowledge {
  Tick now = 0;
  agent::Game game;        // who the robot is, too
  agent::Beliefs beliefs;  // that a robot was never localised is a deviation above kLost
  agent::Mind mind;        // what its agent remembers
  Body body;               // what it does and how it moves; where it is, is a belief
  // of all, own side first:
  Tick away[2][kMaxPlayers] = {};  // [ticks] until who is penalised may come back; 0: plays, kNever: does not
  Tick down[2][kMaxPlayers] = {};  // when it was last told or seen to lie on the ground; 0: it stands
};

/// What `robot` of a simulated game knows.
Knowledge knowledge_of(const Params& params, const State& state, int robot);

/// How far everything may be off: one standard deviation along each axis.
struct Doubt {
  std::uint8_t whose = kNobody;     // robot whose beliefs these are; kNobody: everybody's stay as they are
  float ball = 0;                   // [m]
  float ball_velocity = 0;          // [m/s]
  float ball_elsewhere = 0;         // [0..1] how likely it lies anywhere else on the field
  bool ball_by_own_eyes = false;    // where that robot stands is off, so is the ball
  float position[kMaxRobots] = {};  // [m]
  float heading[kMaxRobots] = {};   // [rad]
};

/// A moment of a game that is known more or less.
struct Situation {
  State state;  // the most likely one
  Doubt doubt;
};

/// A robot whose pose is off by more has no idea where it is.
inline constexpr float kLost = 1.5f;  // [m]
/// The ball cannot be guessed when nobody saw it for longer.
inline constexpr float kBallLost = 30;  // [s]

/// The situation that a robot believes in, or why it cannot tell. Its own side is home and attacks +x: `field` of the
/// state is its `team_field`.
///
/// Teammates are where they said, opponents where they were seen, each the less surely the longer ago; who was never
/// heard or seen stands where it would by the formation. All play by what the whole team knows.
struct Believed {
  Situation situation;
  std::string refusal;  // "the robot does not know where it is: …"; empty when there is a situation
};
Believed believe(const Params& params, const Knowledge& knowledge);

/// What somebody may know of how it truly is.
struct Insight {
  bool ball = false, own_side = false, opponents = false;
};

/// Puts what truly is in place of what a robot of side `own` believes, as if somebody had told it; of that nothing is in
/// doubt any more. `truth` is the world at the same tick. Who has left the field, by belief or in truth, stays as he
/// was. What the robots themselves believe stays.
void tell(const World& truth, Side own, Insight insight, Situation& situation);

/// One of the worlds that the situation may be, drawn by `key` (event `belief`), to be played on with that key. What
/// the robot itself and its team believe of the ball stays, and where it takes itself to be; the world differs. Where the
/// others are is in doubt for it, not for them: they know where they stand, and its opponents the ball. A ball that would
/// be beyond a line lies elsewhere: the referee has put it back.
State sample(const Params& params, const Situation& situation, RandomKey key);

}  // namespace sim::foresight
