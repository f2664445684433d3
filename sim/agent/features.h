// The questions about its beliefs that a tree can ask. The table of features is in features.cpp, one row per feature.
#pragma once

#include <cstdint>
#include <limits>
#include <string_view>

#include "sim/agent/view.h"

namespace sim::agent {

inline constexpr float kUnknown = std::numeric_limits<float>::quiet_NaN();  // value that the robot does not know

/// One row of the table of features.
struct FeatureInfo {
  enum class Kind : std::uint8_t { number, yes_no, name };

  /// Returns the value [SI; 1 or 0 for yes or no; the number of a name], or NaN when the robot does not know it.
  float (*compute)(const View& view);
  bool needs_ball;  // the value is NaN while the ball is unknown; `compute` is then not called
  bool lateral;     // the value changes its sign when left and right are exchanged
  Kind kind;
  const char* name;
  const char* unit;          // "" without a unit
  float least;               // smallest threshold, in `unit`
  float most;                // largest threshold
  const char* const* names;  // kind name: the words for the values 0, 1, …, ended by nullptr; otherwise nullptr
  const char* about;
  bool at_times_unknown = false;  // the value can be NaN although the ball is known
  bool fixed = false;             // the value never changes during a game
};

/// Returns whether the values are whole numbers of things.
inline bool counts(const FeatureInfo& info) {
  const std::string_view unit = info.unit;
  return unit == "robots" || unit == "decisions" || unit == "goals";
}

/// The number of a feature: its row in the table, ours first, then the team's own (sim/agent/own.h).
enum class Feature : std::uint16_t {};
/// The answer of find_feature to an unknown name.
inline constexpr Feature kNoFeature{0xffff};

/// Returns the number of features, the team's own included: their ids are 0 .. feature_count() - 1.
int feature_count();
/// Returns the number of features without the team's own.
int built_in_feature_count();
const FeatureInfo& info_of(Feature feature);
/// Returns the feature of that name, or kNoFeature.
Feature find_feature(std::string_view name);

/// Computes the value, without the view's memory of values.
float compute(Feature feature, const View& view);

/// Returns the value of a feature, NaN when the robot does not know it. Every comparison with NaN is false.
/// The first call computes the value; the view remembers it.
inline float value_of(Feature feature, const View& view) {
  const auto index = static_cast<unsigned>(feature);
  std::uint64_t& known = view.computed[index / 64];
  const std::uint64_t bit = std::uint64_t{1} << (index % 64);
  if (!(known & bit)) {
    view.values[index] = compute(feature, view);
    known |= bit;
  }
  return view.values[index];
}

// parts of features that skills use too

/// The ball rolls towards the own goal and may reach it.
bool rolls_into_own_goal(const View& view);

/// The point where the ball passes the robot's own y axis. NaN when the ball does not pass it.
struct Crossing {
  float time;  // [s] until then
  float left;  // [m, robot] y of the point
};
Crossing crossing(const View& view);

/// Returns the distance [m] from the nearest opponent to the line between two points [team_field], at most 10.
float clearance(const View& view, Vec2 from, Vec2 to);

/// The widest gap between the opponents' posts as seen from the ball: its ends on the goal line [m, team_field y].
struct Gap {
  float right;
  float left;
};
Gap widest_gap(const View& view);

/// The best teammate for a pass.
struct PassTarget {
  int mate = -1;   // index into beliefs.mates, or -1 when no teammate is free
  float gain = 0;  // [m] that the teammate is nearer to the opponents' goal than the ball is
};
PassTarget pass_target(const View& view);

/// Returns whether the ball lies in the gate of `kick` for the left or the right foot. `care` scales the gate.
bool in_gate(const motion::Kick& kick, Vec2 ball, bool left, float care);

}  // namespace sim::agent
