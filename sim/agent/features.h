// What a condition of a tree can ask about the beliefs.
#pragma once

#include <cstdint>
#include <string_view>

#include "sim/agent/view.h"

namespace sim::agent {

enum class Feature : std::uint8_t {
  // the ball
  ball_known,
  ball_visible,
  ball_age,
  team_ball_age,
  ball_deviation,
  ball_distance,
  ball_bearing,
  ball_ahead,
  ball_left,
  ball_speed,
  ball_x,
  ball_y,
  ball_off_centre,
  ball_in_own_half,
  ball_goal_distance,
  ball_own_goal_distance,
  ball_heat,
  ball_approach,
  ball_in_goal_soon,
  crossing_time,
  crossing_left,
  crossing_off,
  // the way to the goal
  goal_bearing,
  goal_opening,
  shot_clearance,
  line_error,
  aligned,
  aligned_for,
  kick_error,
  // others
  time_to_ball,
  mates_time_to_ball,
  mates_active,
  mate_distance,
  opponents_known,
  opponent_distance,
  opponent_ball_distance,
  pass_gain,
  // oneself
  role,
  lane,
  player,
  x,
  y,
  off_centre,
  heading,
  pose_deviation,
  own_goal_distance,
  role_age,
  leaf_age,
  // the game
  our_kick,
  their_kick,
  set_play,
  phase_age,
  seconds_left,
  half,
  score_difference,
  players,
  count,
};
inline constexpr int kFeatureCount = static_cast<int>(Feature::count);
static_assert(kFeatureCount <= kMaxFeatures);
/// What find_feature says of a name that it does not know.
inline constexpr Feature kNoFeature{255};

/// How many there are with those of a team's own (sim/agent/own.h), which follow ours: static_cast<Feature>(0 ..).
int feature_count();

/// One row of the table of features.
struct FeatureInfo {
  enum class Kind : std::uint8_t { number, yes_no, name };
  const char* name;
  Kind kind;
  const char* unit;  // "" where there is none
  float least;       // of a threshold, in `unit`
  float most;
  bool lateral;              // changes its sign when left and right are exchanged
  const char* const* names;  // kind name: what the values 0.. are called, ended by nullptr; else nullptr
  const char* about;
};
const FeatureInfo& info_of(Feature feature);
/// kNoFeature if there is none of that name.
Feature find_feature(std::string_view name);

/// The value [SI; 1 or 0 for yes or no; the number of a name], NaN where the robot does not know: every comparison with
/// it is false. Computed when first asked for, then remembered by the view.
inline float value_of(Feature feature, const View& view);
/// The value as computed now, remembered or not.
float compute(Feature feature, const View& view);
/// Remembers what is known without asking.
inline void remember(Feature feature, float value, const View& view) {
  const auto index = static_cast<unsigned>(feature);
  view.values[index] = value;
  view.asked |= std::uint64_t{1} << index;
}

inline float value_of(Feature feature, const View& view) {
  const auto index = static_cast<unsigned>(feature);
  if (!(view.asked >> index & 1)) remember(feature, compute(feature, view), view);
  return view.values[index];
}

/// Parts of features that skills use too.
/// [m] from the nearest opponent to the line between two points [team_field]; at most 10.
float clearance(const View& view, Vec2 from, Vec2 to);
/// The widest gap between the opponents' posts as seen from the ball: its ends on the goal line [m, team_field y].
struct Gap {
  float right;
  float left;
};
Gap widest_gap(const View& view);
/// Who a pass would go to, an index into beliefs.mates, or -1; sets view.pass_gain [m], how much nearer to the goal.
int pass_mate(const View& view);
/// The ball lies where the kick of Mind.kick wants it, for the left or the right foot.
bool in_gate(const motion::Kick& kick, Vec2 ball, bool left, float care);

}  // namespace sim::agent
