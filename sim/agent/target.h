// The target of the ball, and the directions that are good enough for it.
#pragma once

#include <cstdint>

#include "sim/agent/skills.h"
#include "sim/agent/view.h"

namespace sim::agent {

/// A target of the ball by its name.
enum class Aim : std::uint8_t {
  goal,     // the middle of the opponents' goal
  opening,  // the middle of the widest gap in it; the wider it is, the less exactly
  ahead,    // straight towards the opponents' goal line
  away,     // from the own goal
  mate,     // the free teammate nearest to the goal, ahead of it; without one, ahead
  cross,    // the penalty mark before the goal
};
inline constexpr const char* kAims[] = {"goal", "opening", "ahead", "away", "mate", "cross", nullptr};  // by Aim

/// The target of the ball as a leaf names it: an aim, or instead of it a direction or a point.
struct Where {
  Aim aim = Aim::opening;
  float direction = kNotGiven;  // [rad, team_field]
  float x = kNotGiven;          // [m, team_field]
  float y = kNotGiven;
};

inline constexpr Range kAimRange{.unit = "", .least = 0, .most = 5, .names = kAims, .alternative = true};
inline constexpr Range kDirectionRange{
    .unit = "rad", .least = -3.15f, .most = 3.15f, .lateral = true, .alternative = true, .example = R"("45 deg")"};
inline constexpr Range kTargetX = point_x("target", "[2, -0.5]", true);
inline constexpr Range kTargetY = point_y("target", "[2, -0.5]", true);

inline constexpr const char* kDirectionAbout =
    "instead of the aim: 0 towards the opponents' goal line, > 0 to the left";
inline constexpr const char* kTargetAbout = "instead of the aim: a point of the field, x towards the opponents' goal";

/// The target on the field.
struct Target {
  Vec2 point;       // [m, team_field]
  float slack = 0;  // [m] tolerated distance to each side
};
/// Returns the target of the ball; for a teammate `lead` [m] ahead of it.
Target target_of(const View& view, const Where& where, float lead);

/// The directions in which the ball may go.
struct Sector {
  Vec2 straight;  // [robot] unit vector to the target itself
  Vec2 use;       // (cosine, sine) of the angle to each side that an approach uses
  float allowed;  // cosine of the allowed angle to each side
};
Sector sector_of(const View& view, const Target& target, float tolerance);

/// Returns the direction of the sector nearest to the one in which the ball would go if the robot went straight on.
/// `bend` is the direction of the kick [robot], a unit vector.
Vec2 way_in(const Sector& sector, const View& view, Vec2 bend);

}  // namespace sim::agent
