// The penalty shoot-out after a drawn game: one attacker against one goalkeeper, shot by shot.
#pragma once

#include <vector>

#include "sim/match/params.h"
#include "sim/match/state.h"
#include "sim/referee/shoot_out.h"

namespace sim {

/// One penalty shot.
struct PenaltyShot {
  enum class End : std::uint8_t { goal, out, time_up };

  Side side;   // of the attacker
  End end;     // goal: the attacker's side scored; out: the ball left the field, also into the other goal
  Tick ticks;  // from PLAYING to the end
};
/// Returns the word for a report: "goal", "out", "time up".
const char* name_of(PenaltyShot::End end);

struct ShootOut {
  referee::shoot_out::Tally tally;
  std::vector<PenaltyShot> shots;
};

/// Returns whether the rules have a penalty shoot-out.
constexpr bool has_shoot_out(const field::Rules& rules) { return rules.shoot_out_shots > 0; }

/// Returns the state at the start of a shot of `side`, in PLAYING. The ball lies on the penalty mark, the attacker
/// (player 2) stands kShotRun behind it, the goalkeeper (player 1) in the middle of its goal line. All other robots wait
/// beside the field until the end. Both robots know the ball.
inline constexpr float kShotRun = 1;  // [m] rule book, from memory
State penalty_shot(const Params& params, RandomKey key, Side side);

/// Plays one shot to its end: a goal, a ball that leaves the field, or Rules::shoot_out_duration.
PenaltyShot play_shot(const Params& params, RandomKey key, Side side);

/// Plays a whole shoot-out. Draw::kick_off selects the side that shoots first; each shot has a key of its own. The rules
/// have a shoot-out and at least two players a side.
ShootOut play_shoot_out(const Params& params, RandomKey key);

}  // namespace sim
